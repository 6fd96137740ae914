#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"
#include "tests/worse.h"

namespace fretval::mdr::stick_radius_properties_test {
namespace {

struct Scene {
  PronyBody body;
  double mu;
  Motion motion;
};

class Draw {
 public:
  double uniform(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
  double decades(double lower, double upper) { return std::pow(10, uniform(lower, upper)); }
  bool one_in(int n) { return uniform(0, n) < 1; }

 private:
  std::mt19937 random_{23};
};

// Everything within a few decades of one; every kind of body, and one amplitude zero now and then.
Scene draw_scene(Draw& draw) {
  const PronyBody bodies[] = {elastic(draw.decades(-1, 1)), kelvin_voigt(draw.decades(-1, 1), draw.decades(-3, 1)),
                              standard_solid(draw.decades(-1, 1), draw.decades(-1, 1), draw.decades(-2, 2))};
  const double frequency = draw.decades(-1, 1);
  return {bodies[int(draw.uniform(0, 3))], draw.decades(-1, 1),
          Motion{1, draw.one_in(20) ? 0 : draw.uniform(0, 0.5), draw.one_in(20) ? 0 : draw.uniform(0, 0.5), frequency,
                 frequency, draw.uniform(-2 * pi, 2 * pi)}};
}

StickDepths depths(const Scene& scene) {
  return stick_depths(scene.body, scene.mu, scene.motion);
}

// d0 plus the sum of the two demands: what the depths are differences of.
double size(const Scene& scene) {
  const double rho = modulus_ratio(scene.body, angular_frequency(scene.motion.normal_frequency));
  return scene.motion.indentation +
         rho * (scene.motion.normal_amplitude + scene.motion.tangential_amplitude / scene.mu);
}

constexpr int n_draws = 5000;

// A few rounding errors of the size above.
constexpr double roundoff = 4e-15;

TEST(StickDepthProperties, ShakedownIsNeverBelowFirstSlip) {
  Draw draw;
  for (int i = 0; i < n_draws; ++i) {
    const Scene scene = draw_scene(draw);
    ASSERT_GE(depths(scene).shakedown, depths(scene).first_slip);
    const double rho = modulus_ratio(scene.body, angular_frequency(scene.motion.normal_frequency));
    const double permanent_contact = scene.motion.indentation - rho * scene.motion.normal_amplitude;
    ASSERT_LE(depths(scene).shakedown, permanent_contact + roundoff * size(scene));
  }
}

TEST(StickDepthProperties, MonotoneInFrictionAmplitudesAndIndentation) {
  Draw draw;
  for (int i = 0; i < n_draws; ++i) {
    const Scene scene = draw_scene(draw);
    const double factor = 1 + draw.decades(-3, 1);
    Scene rougher = scene, wider = scene, higher = scene, deeper = scene;
    rougher.mu *= factor;
    wider.motion.tangential_amplitude *= factor;
    higher.motion.normal_amplitude *= factor;
    deeper.motion.indentation *= factor;
    const StickDepths here = depths(scene);
    const double slack = roundoff * (size(wider) + size(higher));
    ASSERT_GE(depths(rougher).first_slip, here.first_slip - slack);
    ASSERT_GE(depths(rougher).shakedown, here.shakedown - slack);
    ASSERT_LE(depths(wider).first_slip, here.first_slip + slack);
    ASSERT_LE(depths(wider).shakedown, here.shakedown + slack);
    ASSERT_LE(depths(higher).first_slip, here.first_slip + slack);
    ASSERT_LE(depths(higher).shakedown, here.shakedown + slack);
    ASSERT_NEAR(depths(deeper).first_slip - here.first_slip, factor - 1, slack + roundoff * factor);
    ASSERT_NEAR(depths(deeper).shakedown - here.shakedown, factor - 1, slack + roundoff * factor);
  }
}

TEST(StickDepthProperties, SymmetricInThePhaseAndEqualAtNinetyDegrees) {
  Draw draw;
  for (int i = 0; i < n_draws; ++i) {
    Scene scene = draw_scene(draw);
    const double phase = *scene.motion.phase;
    const StickDepths here = depths(scene);
    // pi - phase is rounded.
    const double slack = 10 * roundoff * size(scene);
    for (const double twin : {-phase, pi - phase, phase + pi}) {
      scene.motion.phase = twin;
      ASSERT_NEAR(depths(scene).first_slip, here.first_slip, slack);
      ASSERT_NEAR(depths(scene).shakedown, here.shakedown, slack);
    }
    for (const double quadrature : {pi / 2, -pi / 2}) {
      scene.motion.phase = quadrature;
      ASSERT_NEAR(depths(scene).first_slip, depths(scene).shakedown, slack);
    }
  }
}

using Wide = boost::multiprecision::cpp_bin_float_50;

struct WideDepths {
  Wide first_slip;
  Wide shakedown;
  Wide scale;  // d0 or the larger demand
};

// The formulas as they stand, in fifty digits, where neither cancellation nor range is a concern.
WideDepths depths_in_fifty_digits(const Scene& scene) {
  const Wide omega = 2 * boost::math::constants::pi<Wide>() * Wide(scene.motion.normal_frequency);
  Wide storage = scene.body.relaxed_modulus, loss = omega * scene.body.viscosity;
  for (std::size_t i = 0; i < scene.body.branch_moduli.size(); ++i) {
    const Wide x = omega * scene.body.branch_times[i];
    storage += scene.body.branch_moduli[i] * x * x / (1 + x * x);
    loss += scene.body.branch_moduli[i] * x / (1 + x * x);
  }
  const Wide rho = sqrt(storage * storage + loss * loss) / scene.body.relaxed_modulus;
  const Wide tangential = rho * 2 * scene.motion.tangential_amplitude / (3 * Wide(scene.mu));
  const Wide normal = rho * scene.motion.normal_amplitude;
  const Wide cross = 2 * tangential * normal * cos(Wide(*scene.motion.phase));
  const Wide squares = tangential * tangential + normal * normal;
  const Wide forward = sqrt(squares - cross), backward = sqrt(squares + cross);
  const Wide d0 = scene.motion.indentation, larger = std::max(forward, backward);
  return {d0 - larger, d0 - (forward + backward) / 2, std::max(d0, larger)};
}

// Extremes, drawn over the decades: lengths in m, moduli in Pa, mu, omega tau.
Scene draw_extreme_scene(Draw& draw) {
  const double frequency = draw.decades(-6, 6), omega = 2 * pi * frequency;
  const double modulus = draw.decades(-3, 15), length = draw.decades(-12, 6);
  const PronyBody bodies[] = {elastic(modulus), kelvin_voigt(modulus, modulus * draw.decades(-12, 12) / omega),
                              standard_solid(modulus, draw.decades(-3, 15), draw.decades(-12, 12) / omega),
                              prony(modulus, {draw.decades(-3, 15), draw.decades(-3, 15)},
                                    {draw.decades(-12, 12) / omega, draw.decades(-12, 12) / omega})};
  const double phases[] = {0, pi / 2, pi, 1e-9, pi - 1e-9, draw.uniform(-2 * pi, 2 * pi)};
  Motion motion{length,    length * draw.decades(-12, 0),  length * draw.decades(-12, 0), frequency,
                frequency, phases[int(draw.uniform(0, 6))]};
  if (draw.one_in(10)) motion.normal_amplitude = 0;
  if (draw.one_in(10)) motion.tangential_amplitude = 0;
  const double mu = draw.decades(-6, 6);
  // Equal demands, where A e^(i phi) - Delta d vanishes at phi = 0.
  if (draw.one_in(10)) motion.normal_amplitude = 2 * motion.tangential_amplitude / (3 * mu);
  return {bodies[int(draw.uniform(0, 4))], mu, motion};
}

TEST(StickDepthExtremes, AgreeWithFiftyDigits) {
  Draw draw;
  double worst = 0;
  for (int i = 0; i < n_draws; ++i) {
    const Scene scene = draw_extreme_scene(draw);
    const StickDepths here = depths(scene);
    const WideDepths exact = depths_in_fifty_digits(scene);
    ASSERT_TRUE(std::isfinite(here.first_slip) && std::isfinite(here.shakedown));
    for (const Wide& error : {Wide(here.first_slip - exact.first_slip), Wide(here.shakedown - exact.shakedown)})
      worst = worse(worst, static_cast<double>(abs(error) / exact.scale));
  }
  // A few rounding errors, and far below the 1e-10 that is asked for.
  EXPECT_LT(worst, 4e-15);
}

TEST(StickDepthExtremes, DoNotDependOnUnits) {
  Draw draw;
  const double metre = 0.3048e-7, pascal = 6894.757e5, second = 3.6525e3;
  for (int i = 0; i < n_draws; ++i) {
    const Scene scene = draw_extreme_scene(draw);
    Scene other = scene;
    for (double* length :
         {&other.motion.indentation, &other.motion.normal_amplitude, &other.motion.tangential_amplitude})
      *length *= metre;
    other.body.relaxed_modulus *= pascal;
    for (double& modulus : other.body.branch_moduli) modulus *= pascal;
    for (double& time : other.body.branch_times) time *= second;
    other.body.viscosity *= pascal * second;
    other.motion.normal_frequency /= second;
    other.motion.tangential_frequency /= second;
    const double scale = static_cast<double>(depths_in_fifty_digits(scene).scale);
    ASSERT_NEAR(depths(other).first_slip / metre, depths(scene).first_slip, 1e-13 * scale);
    ASSERT_NEAR(depths(other).shakedown / metre, depths(scene).shakedown, 1e-13 * scale);
  }
}

}  // namespace
}  // namespace fretval::mdr::stick_radius_properties_test
