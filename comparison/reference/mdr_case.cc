#include "comparison/reference/mdr_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "comparison/reference/incompressible_case.h"
#include "comparison/scene/scene.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/plane/plane_stick.h"
#include "mdr/rheology/compressible.h"
#include "mdr/springs/path_response.h"
#include "mdr/stick/shakedown_amplitude.h"

namespace fretval {
namespace {

void require_displacements_and_no_wear(const Case& input) {
  const auto refuse = [&](const std::string& entry, const char* valid) {
    throw InputError(fmt::format("{}: {}: the indenter is a table for which MDR does not hold ({}); expected {}",
                                 input.file, entry, falls_text(any_profile_of(input.indenter)), valid));
  };
  if (const auto& path = input.motion.path; path && (path->normal_force || path->tangential_force))
    refuse("Motion / Path = " + path->file, "a path of displacements, the columns t, d, u_x");
  if (input.motion.normal_force) refuse("Motion / Normal force", "an Indentation and a Normal amplitude");
  if (input.motion.tangential_force) refuse("Motion / Tangential force amplitude", "a Tangential amplitude");
  if (std::isnan(input.motion.tangential_amplitude))
    refuse("Motion / Tangential amplitude = shakedown", "a number in m");
  if (input.wear == Case::Wear::limiting) refuse("Wear / State = limiting", "unworn");
  if (input.wear_kinetics) refuse("Wear / Coefficient", "no wear");
  if (input.contact.is_full()) refuse("Contact / Friction = vector", "unidirectional");
}

/// What forces lead to, which is what wear ends in.
void require_limiting_state(const Case& input, const MdrCase& mdr, const std::string& entry) {
  if (!mdr.limiting_state)
    throw InputError(
        fmt::format("{}: {}: there is no limiting state, because no contact carries the prescribed motion "
                    "without slip; expected smaller amplitudes",
                    input.file, entry));
}

mdr::LimitingProfile limiting_under_forces(const MdrCase& mdr) {
  return mdr::limiting_profile(mdr.profile, mdr.limiting_state->stick_radius,
                               mdr::maximum_indentation(mdr.limiting_state->motion));
}

mdr::LimitingProfile limiting_of(const Case& input, const MdrCase& mdr) {
  if (mdr.has_forces()) {
    require_limiting_state(input, mdr, "Wear / State = limiting");
    return limiting_under_forces(mdr);
  }
  const double deepest = mdr::maximum_indentation(mdr.motion);
  const double unworn_radius = mdr::inverse_transform(mdr.profile, deepest),
               stick_radius = input.worn_stick_ratio * unworn_radius;
  if (mdr::transform(mdr.profile, stick_radius) <= 0)
    throw InputError(
        fmt::format("{}: Wear / Stick radius ratio = {:g}: it lies inside the flat face of the indenter, of which all "
                    "or nothing sticks; expected a ratio above {:.4g}",
                    input.file, input.worn_stick_ratio, mdr::inverse_transform(mdr.profile, 0) / unworn_radius));
  return mdr::limiting_profile(mdr.profile, stick_radius, deepest);
}

double amplitude_for_shakedown(const Case& input, const MdrCase& mdr) {
  const double depth = mdr::transform(mdr.profile, mdr.limiting->stick_radius);
  const auto motion = one_harmonic_each_of(input, mdr, "Motion / Tangential amplitude = shakedown");
  const auto amplitude = mdr::tangential_amplitude_for_shakedown(mdr.body, mdr.friction_coefficient, motion, depth);
  if (!amplitude)
    throw InputError(
        fmt::format("{}: Wear / Stick radius ratio = {:g}: no tangential amplitude shakes down there, because "
                    "the contact opens inside it in every cycle; expected a smaller ratio or a smaller Motion / "
                    "Normal amplitude",
                    input.file, input.worn_stick_ratio));
  return *amplitude;
}

/// What finite elements do not do yet, and the entry that asks for it; empty: nothing.
std::string why_not_comparable(const Case& input) {
  const auto& motion = input.motion;
  const auto path = harmonic_motion_of(motion);
  if (motion.path) return "";
  if (motion.normal_force && !(mdr::minimum_indentation({path.indentation, path.normal, {}}) > 0))
    return fmt::format(
        "Motion / Normal force amplitude = {:g}: a normal force that is not positive all the time, as smaller "
        "oscillations about its mean of {:g} N would be, is not balanced",
        motion.normal_force->amplitude, motion.normal_force->mean);
  if (mdr::harmonic_groups(path).size() > 2)
    return "Motion / Normal harmonics, Tangential harmonics: three frequencies of which no two have a common period, "
           "for which MDR has a bound alone, are not computed";
  constexpr double largest_ratio = 1000;
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0;
  for (const auto* harmonics : {&path.normal, &path.tangential})
    for (const auto& [amplitude, frequency, phase, across] : *harmonics) {
      if (amplitude == 0) continue;
      slowest = std::min(slowest, frequency);
      fastest = std::max(fastest, frequency);
    }
  if (fastest > largest_ratio * slowest)
    return fmt::format("Motion: frequencies of {:g} and {:g} Hz, more than a factor of {:g} apart, are not computed",
                       slowest, fastest, largest_ratio);
  return "";
}

/// Why MDR for layers cannot be asked, and the entry that asks for it; empty: it can.
std::string why_not_on_layer(const Case& input) {
  if (input.wear == Case::Wear::limiting) return "Wear / State = limiting: a limiting profile over a layer";
  if (!input.wear_kinetics) return "";
  const auto& motion = input.motion;
  if (motion.path) return "Motion / Path = " + motion.path->file + ": wear along a path over a layer";
  if (!motion.normal_harmonics.empty() || !motion.tangential_harmonics.empty())
    return "Motion / Normal harmonics, Tangential harmonics: wear over a layer under several of them";
  if (motion.phase && motion.normal_frequency != motion.tangential_frequency)
    return fmt::format("Motion / Tangential frequency = {:g}: wear over a layer under two frequencies",
                       motion.tangential_frequency);
  return "";
}

/// Refuses what neither method computes of a case on this body.
void require_known_body(const Case& input) {
  if (input.body.shape == Case::Body::Shape::layer)
    if (const auto why = why_not_on_layer(input); !why.empty())
      throw InputError(
          fmt::format("{}: {} is not computed, as what it would end in is not known there; leave the Body "
                      "out, or expected an unworn indenter",
                      input.file, why));
  if (!input.body.is_half_space() && !falls_text(any_profile_of(input.indenter)).empty())
    throw InputError(
        fmt::format("{}: Body / Shape: the indenter is a table for which MDR does not hold, which is computed over a "
                    "half-space alone; leave the Body out, or expected a profile whose image rises",
                    input.file));
  if (input.body.grid && input.wear == Case::Wear::limiting)
    throw InputError(fmt::format(
        "{}: Wear / State = limiting: it takes rings that are graded to its edge, which Body / Mesh has not; "
        "expected unworn, or another Body / Shape",
        input.file));
}

}  // namespace

bool is_comparable(const Case& input) {
  return why_not_comparable(input).empty();
}

std::vector<std::string> beyond_mdr_model(const Case& input) {
  std::vector<std::string> reasons;
  if (input.body.shape == Case::Body::Shape::cylinder) reasons.emplace_back("the body is a cylinder");
  if (input.body.shape == Case::Body::Shape::mesh) reasons.emplace_back("the body is that of a mesh");
  if (input.body.shape == Case::Body::Shape::layer && !is_layer_of_mdr(input))
    reasons.emplace_back("the body is a layer under a motion in two directions");
  if (input.contact.vector_friction) reasons.emplace_back("friction is a vector");
  if (input.contact.coupled) reasons.emplace_back("pressure and friction are coupled");
  return reasons;
}

mdr::FrettingControl control_of(const mdr::Prescribed& prescribed) {
  const auto& motion = prescribed.motion;
  const auto &normal = motion.normal.front(), &tangential = motion.tangential.front();
  mdr::FrettingControl control{mdr::IndentationControl{motion.indentation, normal.amplitude},
                               mdr::TangentialDisplacementControl{tangential.amplitude},
                               normal.frequency,
                               tangential.frequency,
                               {}};
  if (prescribed.normal_force) control.normal = mdr::NormalForceControl{motion.indentation, normal.amplitude};
  if (prescribed.tangential_force) control.tangential = mdr::TangentialForceControl{tangential.amplitude};
  if (motion.phase_locked) control.phase = tangential.phase - normal.phase;
  return control;
}

mdr::Motion one_harmonic_each_of(const Case& input, const MdrCase& mdr, const std::string& what) {
  if (mdr.has_forces())
    throw InputError(fmt::format("{}: {}: it needs prescribed displacements in both directions", input.file, what));
  const auto motion = mdr::one_harmonic_each(mdr.motion);
  if (!motion) throw InputError(fmt::format("{}: {}: it needs one harmonic in each direction", input.file, what));
  return *motion;
}

mdr::Prescribed MdrCase::prescribed_normally() const {
  mdr::Prescribed normal{motion, normal_force};
  normal.motion.tangential.clear();
  normal.motion.phase_locked = true;
  return normal;
}

double unworn_radius_at(const MdrCase& mdr, double indentation) {
  return mdr.layer ? mdr::layer_contact_at_depth(mdr.profile, *mdr.layer, indentation).contact_radius
                   : mdr::inverse_transform(mdr.profile, indentation);
}

double deepest_indentation(const MdrCase& mdr) {
  if (mdr.layer) {
    // A layer gives way less than a half-space.
    const auto half_space = mdr::incompressible_equivalent(mdr.body, mdr.layer->poisson_ratio);
    if (mdr.path) return mdr::deepest_indentation(mdr.profile, half_space, *mdr.path);
    return mdr::deepest_indentation(mdr.profile, half_space, mdr.prescribed());
  }
  if (mdr.path) return mdr::deepest_indentation(mdr.profile, mdr.body, *mdr.path);
  return mdr.limiting && mdr.has_forces() ? mdr::maximum_indentation(mdr.limiting_state->motion)
                                          : mdr::deepest_indentation(mdr.profile, mdr.body, mdr.prescribed());
}

ExpectedContact expected_contact(const MdrCase& mdr) {
  const auto& state = mdr.limiting_state;
  return {deepest_indentation(mdr), state ? std::optional(state->stick_radius) : std::nullopt};
}

std::optional<LimitingIndenter> limiting_indenter(const MdrCase& mdr) {
  if (!mdr.limiting) return std::nullopt;
  return LimitingIndenter{mdr.limiting->stick_radius, mdr.limiting->outer_radius,
                          [worn = *mdr.limiting](double r) { return mdr::shape(worn, r); },
                          mdr.motion.tangential.front().amplitude / mdr.displacement};
}

MdrCase mdr_case(const Case& input_of_any_body) {
  if (const auto reason = why_not_comparable(input_of_any_body); !reason.empty())
    throw InputError(
        fmt::format("{}: {} by the finite elements; `fretval mdr` answers this case", input_of_any_body.file, reason));
  require_known_body(input_of_any_body);
  const auto [input, displacement] = incompressible_case(input_of_any_body);
  const auto& motion = input.motion;
  const bool amplitude_follows = std::isnan(motion.tangential_amplitude);
  if (amplitude_follows && motion.normal_force)
    throw InputError(
        fmt::format("{}: Motion / Tangential amplitude = shakedown: it belongs to an Indentation; under a Normal force "
                    "it has to be "
                    "a number in m",
                    input.file));
  const auto profile = any_profile_of(input.indenter);
  if (!mdr::falls_of_image(profile).empty()) require_displacements_and_no_wear(input);
  MdrCase mdr{profile, body_in_time(input), input.friction_coefficient, motion_of_case(motion), {}};
  mdr.normal_force = motion.normal_force.has_value();
  mdr.tangential_force = motion.tangential_force.has_value();
  mdr.displacement = displacement;
  mdr.tolerance = input.tolerance;
  mdr.cycle_tolerance = input.cycle_tolerance;
  if (motion.path) {
    mdr.path = *motion.path;
    mdr.motion_kind = motion_kind_of(motion);
  }
  if (is_layer_of_mdr(input))
    mdr.layer = mdr::Layer{input.body.thickness, input.elastomer.poisson_ratio,
                           input.body.is_bonded ? mdr::LayerBase::bonded : mdr::LayerBase::frictionless};
  const bool repeats_by_force = mdr.has_forces() && !mdr.path && !mdr.layer;
  if (repeats_by_force && motion.moves_across() && input.wear_kinetics)
    mdr.limiting_state = mdr::limiting_motion(
        mdr.profile, rheology_of(input.elastomer), mdr.motion, mdr.normal_force, mdr.tangential_force,
        [&mdr](const mdr::HarmonicMotion& displacements) {
          return mdr::plane_stick_depths(mdr::Rheology(mdr.body), mdr.friction_coefficient, displacements).shakedown;
        });
  else if (repeats_by_force && !motion.moves_across())
    mdr.limiting_state =
        mdr::limiting_motion(mdr.profile, rheology_of(input.elastomer), mdr.friction_coefficient, mdr.motion,
                             mdr.normal_force, mdr.tangential_force, mdr::StickCriterion::shakedown);
  if (mdr.has_forces() && input.wear_kinetics && !mdr.layer)
    require_limiting_state(input, mdr, fmt::format("Wear / Coefficient = {:g}", input.wear_kinetics->coefficient));
  if (input.wear == Case::Wear::limiting) mdr.limiting = limiting_of(input, mdr);
  if (amplitude_follows) mdr.motion.tangential.front().amplitude = amplitude_for_shakedown(input, mdr);
  return mdr;
}

std::optional<double> steady_sliding_share(const MdrCase& mdr) {
  const auto& motion = mdr.motion;
  const bool one_each = motion.normal.size() == 1 && motion.tangential.size() == 1;
  if (mdr.path || !mdr.normal_force || !mdr.tangential_force || !one_each) return std::nullopt;
  const auto &normal = motion.normal.front(), &tangential = motion.tangential.front();
  const double carried = mdr.friction_coefficient * normal.amplitude;
  double demanded = tangential.amplitude + carried;
  if (motion.phase_locked && normal.amplitude > 0) {
    if (normal.frequency != tangential.frequency) return std::nullopt;
    const auto force = std::polar(tangential.amplitude, tangential.phase - normal.phase);
    demanded = std::max(std::abs(force + carried), std::abs(force - carried));
  }
  if (demanded == 0) return std::nullopt;
  return mdr.friction_coefficient * motion.indentation / demanded;
}

}  // namespace fretval
