#include "comparison/trust/map_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "comparison/model_error/coordinates.h"
#include "mdr/layer/layer.h"

namespace fretval {
namespace {

constexpr double contact_radius = 1e-3, relaxed_modulus = 1e6, frequency = 1;

/// Where a falling function on 0 to 1 reaches a value, to a slack: bisection with secants (Illinois).
template <class Function>
double where_it_reaches(Function function, double value, double slack) {
  double low = 0, high = 1, at_low = function(low) - value, at_high = function(high) - value, middle = 0;
  for (int n = 0, most = 40, last = 0; n < most; ++n) {
    middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_middle = function(middle) - value;
    if (std::abs(at_middle) < slack) break;
    const bool falls_later = at_middle > 0;
    if (falls_later) {
      low = middle, at_low = at_middle;
      if (last == 1) at_high /= 2;
    } else {
      high = middle, at_high = at_middle;
      if (last == -1) at_low /= 2;
    }
    last = falls_later ? 1 : -1;
  }
  return middle;
}

Case at_rest(const MapScene& scene) {
  Case input;
  input.name = input.file = "map";
  if (scene.cone_angle > 0) {
    input.indenter.shape = Case::Shape::cone;
    input.indenter.slope_angle = scene.cone_angle;
  } else {
    constexpr double radius = 1e-2;
    input.indenter.radius = radius;
  }
  input.elastomer.rheology = scene.viscoelastic ? Case::Rheology::standard_solid : Case::Rheology::elastic;
  input.elastomer.relaxed_modulus = relaxed_modulus;
  input.elastomer.poisson_ratio = scene.poisson_ratio;
  if (scene.viscoelastic) {
    constexpr double of_radian = 0.15915494309189535;
    input.elastomer.branch_moduli = {2 * relaxed_modulus};
    input.elastomer.branch_times = {of_radian / frequency};
  }
  if (scene.radius_over_thickness > 0) {
    input.body.shape = Case::Body::Shape::layer;
    input.body.thickness = contact_radius / scene.radius_over_thickness;
  }
  input.friction_coefficient = scene.friction_coefficient;
  input.motion.normal_frequency = input.motion.tangential_frequency = frequency;
  input.motion.phase = scene.phase;
  input.tolerance = 1e-2;
  return input;
}

/// The load of the relaxed body at rest, when the contact has its radius.
struct Load {
  double indentation, normal_force;
};

Load largest_load(const MapScene& scene) {
  auto resting = scene;
  resting.viscoelastic = false;
  auto input = at_rest(resting);
  // A layer takes less than the half-space, whose indentation is that of the image.
  const double over_half_space = mdr::transform(profile_of(input.indenter), contact_radius);
  input.motion.indentation = over_half_space;
  input.motion.tangential_amplitude = over_half_space / 2;
  const auto mdr = mdr_case(input);
  constexpr double slack = 1e-9;
  const double share =
      scene.radius_over_thickness > 0
          ? 1 - where_it_reaches(
                    [&](double less) {
                      return less == 1 ? 0 : unworn_radius_at(mdr, (1 - less) * over_half_space) / contact_radius;
                    },
                    1 - slack, slack)
          : 1;
  input.motion.indentation = share * over_half_space;
  return {input.motion.indentation, mdr_normal_response(mdr_case(input)).normal_force_max};
}

/// Amplitudes rise together with a share.
void set_amplitudes(const MapScene& scene, const Load& load, double share, Case& input) {
  auto& motion = input.motion;
  // A = u_x0 over mu and the ratio of the springs' moduli
  motion.tangential_amplitude =
      share * load.indentation * scene.friction_coefficient * mdr::spring_modulus_ratio(scene.poisson_ratio);
  const double largest = scene.by_normal_force ? load.normal_force : load.indentation;
  const double normal = scene.amplitude_ratio * share * largest;
  if (scene.by_normal_force) {
    motion.normal_force = {largest - normal, normal};
  } else {
    motion.indentation = largest - normal;
    motion.normal_amplitude = normal;
  }
}

}  // namespace

Case case_of(const MapScene& scene) {
  auto input = at_rest(scene);
  const auto load = largest_load(scene);
  const auto stick_ratio = [&](double share) {
    if (share == 0) return 1.0;
    if (share == 1) return 0.0;
    set_amplitudes(scene, load, share, input);
    return coordinates_of(input).shakedown.value_or(0);
  };
  constexpr double slack = 5e-3;  // points lie where they lie; springs over a layer are stepped for each try
  const double share = where_it_reaches(stick_ratio, scene.stick_ratio, slack);
  if (std::abs(stick_ratio(share) - scene.stick_ratio) > slack)
    throw std::runtime_error(fmt::format("no amplitudes lead to a stick ratio of {:g}", scene.stick_ratio));
  input.contact = {true, scene.coupled};
  return input;
}

}  // namespace fretval
