#include "mdr/springs/spring_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/profiles/indentation.h"
#include "mdr/stick/surface_fields.h"
#include "tests/worse.h"

namespace fretval::mdr::spring_fields_test {
namespace {

// Elastic springs against the closed forms of Hertz and of Cattaneo and Mindlin, on and off the contact.
TEST(SpringFields, AreThoseOfHertzAndCattaneoMindlin) {
  const Profile sphere = parabola(2);
  const double d = 0.1, u_x = 0.02, mu = 0.4, G = 3, a = inverse_transform(sphere, d);
  double before = 0;
  for (const Eigen::Index n : {200, 400, 800}) {
    const SpringBed bed = spring_bed(sphere, 1.3 * a, n);
    SpringState state = relaxed_state(bed, elastic(G), d);
    SpringStep(elastic(G), mu, 1).advance(state, bed, {d, 0, u_x, 0});
    const SpringFields fields = spring_fields(bed, elastic(G), state);
    double worst = 0;
    for (const double s : {0.0, 0.2, 0.77, 0.95, 1.1, 1.25}) {
      const double r = s * a, p0 = pressure(sphere, G, d, 0);
      for (const double error :
           {std::abs(pressure(fields, r) - pressure(sphere, G, d, r)) / p0,
            std::abs(traction(fields, r) - traction_cattaneo_mindlin(sphere, G, mu, d, u_x, r)) / p0,
            std::abs(normal_displacement(fields, r) - normal_displacement(sphere, d, r)) / d,
            std::abs(tangential_displacement(fields, r) -
                     tangential_displacement_cattaneo_mindlin(sphere, mu, d, u_x, r)) /
                u_x})
        worst = worse(worst, error);
    }
    // Between first and second order: the springs at the edges are in contact, or slip, in part.
    if (before > 0) {
      EXPECT_LT(worst, 0.6 * before) << n;
    }
    before = worst;
    EXPECT_NEAR(normal_displacement(fields, 50 * a) / normal_displacement(sphere, d, 50 * a), 1, 10.0 / (n * n) + 1e-4);
  }
  EXPECT_LT(before, 1e-3);
}

TEST(SpringFields, RejectABadRadius) {
  const SpringBed bed = spring_bed(parabola(1), 1, 10);
  const SpringFields fields = spring_fields(bed, elastic(1), relaxed_state(bed, elastic(1), 0.1));
  EXPECT_THROW(pressure(fields, -1), std::invalid_argument);
  EXPECT_THROW(normal_displacement(fields, NAN), std::invalid_argument);
  EXPECT_EQ(pressure(fields, 2), 0);
}

}  // namespace
}  // namespace fretval::mdr::spring_fields_test
