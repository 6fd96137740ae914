#include "comparison/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>
#include <variant>
#include <vector>

#include "comparison/data/table_units.h"
#include "comparison/support/constants.h"
#include "mdr/profiles/profile_csv.h"
#include "mdr/rheology/prony_approximation.h"

namespace fretval {
namespace {

/// Heights that scatter are those of a convex profile.
mdr::Profile profile_from_table(const Case::Indenter& indenter) {
  std::ifstream stream(indenter.table);
  return input_from(indenter.table, [&]() -> mdr::Profile {
    if (const auto& trace = indenter.trace) return mdr::tabulated(trace->r, trace->f, trace->row_noise);
    if (indenter.table_noise != 0) return mdr::read_profile_table(stream, indenter.table, indenter.table_noise);
    const auto rows = mdr::read_profile_rows(stream, indenter.table);
    return mdr::tabulated_as_it_is(rows.r, rows.f);
  });
}

std::optional<double> phase_of(const Case::Motion& motion) {
  if (!motion.phase) return std::nullopt;
  return *motion.phase * degree;
}

std::vector<mdr::Harmonic> with_first(const mdr::Harmonic& first, const std::vector<Case::Harmonic>& more) {
  std::vector<mdr::Harmonic> harmonics{first};
  for (const auto& [amplitude, frequency, phase] : more) harmonics.push_back({amplitude, frequency, phase * degree});
  return harmonics;
}

}  // namespace

std::string falls_text(const mdr::Profile& profile) {
  std::string text;
  const auto falls = mdr::falls_of_image(profile);
  constexpr std::size_t most = 3;
  for (std::size_t k = 0; k < std::min(falls.size(), most); ++k)
    text += fmt::format("{}{:.4g} to {:.4g} m", k == 0 ? "its one-dimensional image g(x) falls for x = " : ", ",
                        falls[k].from, falls[k].to);
  if (falls.size() > most) text += fmt::format(" and in {} places more", falls.size() - most);
  return text;
}

mdr::Profile profile_of(const Case::Indenter& indenter) {
  auto profile = any_profile_of(indenter);
  if (!mdr::falls_of_image(profile).empty())
    throw InputError(
        fmt::format("{}: MDR does not hold for this profile: {}, so that the contact is not one full circle at every "
                    "indentation; expected a profile whose image rises, as that of any convex one; `fretval run` "
                    "answers this case by finite elements",
                    indenter.table, falls_text(profile)));
  return profile;
}

mdr::Profile any_profile_of(const Case::Indenter& indenter) {
  switch (indenter.shape) {
    case Case::Shape::parabola:
      return mdr::parabola(indenter.radius);
    case Case::Shape::sphere:
      return mdr::sphere(indenter.radius);
    case Case::Shape::cone:
      return mdr::cone(indenter.slope_angle * degree);
    case Case::Shape::power:
      return mdr::power_law(indenter.coefficient, indenter.exponent);
    case Case::Shape::rounded_flat:
      return mdr::rounded_flat(indenter.flat_radius, indenter.edge_radius);
    case Case::Shape::truncated_sphere:
      return mdr::truncated_sphere(indenter.radius, indenter.flat_radius);
    case Case::Shape::table:
      break;
  }
  return profile_from_table(indenter);
}

mdr::Rheology rheology_of(const Case::Elastomer& elastomer) {
  if (elastomer.fractional_order > 0)
    return mdr::FractionalZener{elastomer.relaxed_modulus, elastomer.branch_moduli.at(0), elastomer.branch_times.at(0),
                                elastomer.fractional_order};
  return mdr::prony(elastomer.relaxed_modulus, elastomer.branch_moduli, elastomer.branch_times, elastomer.viscosity);
}

mdr::PronyBody body_in_time(const Case& input) {
  const auto rheology = rheology_of(input.elastomer);
  if (const auto* body = std::get_if<mdr::PronyBody>(&rheology)) return *body;
  double lowest = std::min(input.motion.normal_frequency, input.motion.tangential_frequency);
  for (const auto* harmonics : {&input.motion.normal_harmonics, &input.motion.tangential_harmonics})
    for (const auto& harmonic : *harmonics) lowest = std::min(lowest, harmonic.frequency);
  return mdr::prony_approximation(std::get<mdr::FractionalZener>(rheology), lowest / 10, lowest * 1000).body;
}

mdr::HarmonicMotion harmonic_motion_of(const Case::Motion& motion) {
  const auto& force = motion.normal_force;
  const double mean = force ? force->mean : motion.indentation,
               normal = force ? force->amplitude : motion.normal_amplitude,
               tangential = motion.tangential_force.value_or(motion.tangential_amplitude);
  auto along =
      with_first({tangential, motion.tangential_frequency, phase_of(motion).value_or(0)}, motion.tangential_harmonics);
  for (const auto& [amplitude, frequency, phase] : motion.transverse)
    along.push_back({amplitude, frequency, phase * degree, true});
  return {mean, with_first({normal, motion.normal_frequency, 0}, motion.normal_harmonics), std::move(along),
          motion.phase.has_value()};
}

mdr::HarmonicMotion motion_of_case(const Case::Motion& motion, const std::optional<LimitingIndenter>& limiting) {
  auto harmonic = harmonic_motion_of(motion);
  const bool amplitude_follows = std::isnan(motion.tangential_amplitude);
  if (amplitude_follows) harmonic.tangential.front().amplitude = 0;
  harmonic = mdr::from_largest_indentation(mdr::without_still_harmonics(harmonic));
  if (amplitude_follows && limiting) harmonic.tangential.front().amplitude = limiting->tangential_amplitude;
  return harmonic;
}

}  // namespace fretval
