#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_document.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

Eigen::VectorXd column_of(const std::vector<Column>& columns, const std::string& name) {
  for (const auto& column : columns)
    if (column.name == name) return column.values;
  ADD_FAILURE() << "no column " << name;
  return {};
}

// Hertz: p = 8 G a/(pi R) sqrt(1 - r^2/a^2), and the surface follows the indenter.
TEST(SurfaceColumns, OfAnElasticSphereAreHertzs) {
  const auto scene = read_case(elastic_case());
  const auto columns = surface_columns(scene, std::nullopt);
  const double R = scene.indenter.radius, d = 1.2e-4, a = std::sqrt(R * d), peak = 8e6 * a / (std::acos(-1.0) * R);
  const auto r = column_of(columns, "r [m]"), p = column_of(columns, "p deepest [Pa]"),
             u = column_of(columns, "u_z deepest [m]"), f = column_of(columns, "f [m]");
  EXPECT_GT(r.maxCoeff(), 1.5 * a);
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    EXPECT_NEAR(f[i] / (r[i] * r[i] / (2 * R)), 1, 1e-12);
    if (r[i] < 0.98 * a) {
      EXPECT_NEAR(p[i], peak * std::sqrt(1 - r[i] * r[i] / (a * a)), 1e-2 * peak) << r[i] / a;
      EXPECT_NEAR(u[i], d - f[i], 1e-3 * d) << r[i] / a;
    }
    if (r[i] > 1.02 * a) {
      EXPECT_EQ(p[i], 0) << r[i] / a;
    }
  }
}

// Half as deep at the other end. An indenter that slides drags the surface along with mu p: backwards at the deepest
// position, forwards at the highest one, 60 degrees behind.
TEST(SurfaceColumns, OfASlidingSphereAreThoseOfBothEnds) {
  auto scene = read_case(elastic_case());
  scene.motion.indentation = 9e-5;
  scene.motion.normal_amplitude = 3e-5;
  scene.motion.tangential_amplitude = 2e-3;
  const auto columns = surface_columns(scene, std::nullopt);
  const auto r = column_of(columns, "r [m]");
  for (const auto& [end, depth, sense] : {std::tuple("deepest", 12e-5, -1), std::tuple("highest", 6e-5, 1)}) {
    const std::string at = std::string(" ") + end + " ";
    const double a = std::sqrt(1e-2 * depth), peak = 8e6 * a / (std::acos(-1.0) * 1e-2);
    const auto p = column_of(columns, "p" + at + "[Pa]"), tau = column_of(columns, "tau" + at + "[Pa]"),
               u_z = column_of(columns, "u_z" + at + "[m]");
    EXPECT_NEAR(p[0], peak, 1e-2 * peak) << end;
    EXPECT_NEAR(u_z[0], depth, 1e-3 * depth) << end;
    for (Eigen::Index i = 0; i < r.size(); ++i) EXPECT_NEAR(tau[i], sense * 0.5 * p[i], 1e-6 * peak) << end << r[i] / a;
    // Displacement of the middle under tractions mu p: 3/2 mu d, as under the normal ones d.
    EXPECT_NEAR(column_of(columns, "u_x" + at + "[m]")[0], sense * 0.75 * depth, 1e-3 * depth) << end;
  }
}

// Hertz with E* = 2 G/(1 - nu); tractions mu p move the middle by E*/G* mu d, with G* = 4 G/(2 - nu).
TEST(SurfaceColumns, OfACompressibleBodyAreItsOwn) {
  auto scene = read_case(elastic_case());
  const double nu = 0.3, d = 12e-5, mu = 0.5, pi = std::acos(-1.0);
  scene.elastomer.poisson_ratio = nu;
  scene.motion.tangential_amplitude = 2e-3;
  const auto columns = surface_columns(scene, std::nullopt);
  const double peak = 4 * scene.elastomer.relaxed_modulus / (1 - nu) * std::sqrt(1e-2 * d) / (pi * 1e-2);
  EXPECT_NEAR(column_of(columns, "p deepest [Pa]")[0], peak, 1e-2 * peak);
  EXPECT_NEAR(column_of(columns, "tau deepest [Pa]")[0], -mu * peak, 1e-2 * mu * peak);
  EXPECT_NEAR(column_of(columns, "u_z deepest [m]")[0], d, 1e-3 * d);
  EXPECT_NEAR(column_of(columns, "u_x deepest [m]")[0], -mu * (2 - nu) / (2 * (1 - nu)) * d, 1e-3 * d);
  scene.motion.tangential_amplitude = 1e-6;  // the middle sticks and moves with the indenter, at 60 degrees
  EXPECT_NEAR(column_of(surface_columns(scene, std::nullopt), "u_x deepest [m]")[0], 0.5e-6, 1e-9);
}

TEST(SurfaceColumns, OfALayerAreRefused) {
  auto scene = read_case(elastic_case());
  scene.body.shape = Case::Body::Shape::layer;
  scene.body.thickness = 3e-3;
  EXPECT_THROW(surface_columns(scene, std::nullopt), InputError);
}

TEST(SurfaceColumns, OfTheLimitingStateAreThereForALockedPhase) {
  auto scene = read_case(elastic_case());
  const auto mdr = mdr_case(scene);
  const auto worn = worn_profile(mdr, mdr_answer(mdr, mdr_normal_response(mdr)).stick_radius_shakedown);
  const auto columns = surface_columns(scene, worn);
  const auto r = column_of(columns, "r [m]"), pressure = column_of(columns, "p worn [Pa]"),
             profile = column_of(columns, "f worn [m]"), unworn = column_of(columns, "f [m]");
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    EXPECT_GE(profile[i], unworn[i] * (1 - 1e-12));
    if (r[i] > worn->stick_radius) {
      EXPECT_EQ(pressure[i], 0) << "nothing wears outside";
    }
  }
  EXPECT_EQ(columns.size(), surface_columns(scene, std::nullopt).size() + 4);
}

}  // namespace
}  // namespace fretval
