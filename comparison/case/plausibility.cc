#include "comparison/case/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "comparison/case/oscillations.h"
#include "comparison/case/table_noise.h"
#include "comparison/case/test_duration.h"
#include "mdr/profiles/profile_csv.h"

namespace fretval {
namespace {

constexpr double least_modulus = 1e3, largest_modulus = 1e9;  // Pa; gels to stiff rubbers below their glass transition
constexpr double least_rise = 1e-3, largest_rise = 0.5;       // of the indenter at the edge of the contact
constexpr double least_ratio = 1e-2;                          // a/R of what has a radius
constexpr double arc_matters = 0.01;                          // of the contact radius
constexpr double difference_matters = 1e-6;                   // of two halves of a scan, over their heights; roundoff

/// What the halves of a two-sided scan differ by; the case has been read from it before.
void add_difference_of_halves(const std::string& table, double noise, std::vector<std::string>& warnings) {
  if (table.empty()) return;
  std::ifstream stream(table);
  const auto halves = mdr::read_profile_rows(stream, table, noise).halves;
  if (!halves || !(halves->largest_difference > difference_matters * halves->range())) return;
  warnings.push_back(fmt::format(
      "{}: the halves of the scan differ by up to {:.2g} m, {:.1f} % of the range of heights, at r = {:.3g} m; their "
      "mean is taken",
      table, halves->largest_difference, 100 * halves->largest_difference / halves->range(),
      halves->radius_of_difference));
}

/// A sphere of metres that was meant in millimetres: at one indentation a/R = sqrt(d/R).
std::string flat_text(const Case& input, double deepest, double a) {
  const double radius = input.indenter.radius, in_mm = radius / 1e3;
  const double least = deepest / (largest_rise * largest_rise), most = deepest / (least_ratio * least_ratio);
  auto text = fmt::format(
      "{}: Indenter / Radius = {:.4g} m: at the largest indentation, {:.3g} m, the contact radius is {:.3g} m and a/R "
      "is "
      "{:.2g}; {} to {} are usual, which at this indentation are radii of {:.2g} to {:.2g} m; are all lengths in m?",
      input.file, radius, deepest, a, a / radius, least_ratio, largest_rise, least, most);
  if (in_mm >= least && in_mm <= most)
    text += fmt::format(" With {:.4g} mm a/R would be {:.2g}", radius, std::sqrt(deepest / in_mm));
  return text;
}

/// Warning about branches that no test sees relax, with the entry to set.
void add_slow_branches(const Case& input, std::vector<std::string>& warnings) {
  const auto slow = times_slower_than(many_cycles, input);
  if (slow.empty()) return;
  warnings.push_back(fmt::format(
      "{}: {} of {} branches relax more slowly than in {:.0e} cycles, in {:.2g} s to {:.2g} s; the relaxed modulus, "
      "{:.3g} Pa, is that of a body that has relaxed for longer than any of them; set Elastomer / Duration of the test "
      "to how long the test lasts, so that slower ones count as springs",
      input.file, slow.size(), input.elastomer.branch_times.size(), many_cycles, slow.front(), slow.back(),
      input.elastomer.relaxed_modulus));
}

/// Warning about a motion at frequencies at which nobody has measured the moduli.
void add_unmeasured_frequencies(const Case& input, std::vector<std::string>& warnings) {
  const auto& curve = input.elastomer.master_curve;
  if (!curve || curve->frequency.empty()) return;
  const auto [least, most] = std::minmax_element(curve->frequency.begin(), curve->frequency.end());
  std::set<double> unmeasured;
  for (const double frequency : moving_frequencies(input.motion))
    if (frequency < *least || frequency > *most) unmeasured.insert(frequency);
  for (const double frequency : unmeasured)
    warnings.push_back(fmt::format(
        "{}: the indenter moves at {:.3g} Hz, where {} has no moduli (it has {:.3g} to {:.3g} Hz): those there are "
        "extrapolated by the fit, and no error bar knows how well",
        input.file, frequency, curve->table, *least, *most));
}

}  // namespace

std::string hint_at_modulus(const Case& input) {
  const auto& body = input.elastomer;
  constexpr double least_share = 1e-3;
  const double stiffest =
      body.branch_moduli.empty() ? 0 : *std::max_element(body.branch_moduli.begin(), body.branch_moduli.end());
  const bool is_soft = body.relaxed_modulus < least_modulus || body.relaxed_modulus < least_share * stiffest;
  if (!is_soft || body.master_curve) return "";
  auto text = fmt::format("; the relaxed modulus, Elastomer / Relaxed shear modulus = {:.4g} Pa, is so small",
                          body.relaxed_modulus);
  if (stiffest > 0) text += fmt::format(" beside a branch of {:.3g} Pa", stiffest);
  return text + " that the body hardly returns: is it in Pa?";
}

std::vector<std::string> implausible_values(const Case& input, const mdr::Profile& profile) {
  std::vector<std::string> warnings;
  const double modulus = input.elastomer.relaxed_modulus;
  if (modulus < least_modulus || modulus > largest_modulus)
    warnings.push_back(
        fmt::format("{}: a relaxed shear modulus of {:.3g} Pa is implausible for an elastomer, {:.0e} to "
                    "{:.0e} Pa are usual; is it in Pa?",
                    input.file, modulus, least_modulus, largest_modulus));
  if (!input.indenter.trace) add_difference_of_halves(input.indenter.table, input.indenter.table_noise, warnings);
  add_slow_branches(input, warnings);
  add_unmeasured_frequencies(input, warnings);
  if (input.wear_kinetics) add_difference_of_halves(input.wear_kinetics->profile, 0, warnings);
  if (const auto noise = noise_behind_falls(input.indenter))
    warnings.push_back(
        fmt::format("{}: MDR does not hold for the heights as they are: {}", input.indenter.table, noise_text(*noise)));
  if (input.motion.path)
    for (auto& warning : noisy_start(*input.motion.path, input.tolerance)) warnings.push_back(std::move(warning));
  if (input.motion.normal_force || !mdr::falls_of_image(profile).empty()) return warnings;
  double deepest = input.motion.indentation + input.motion.normal_amplitude;
  for (const auto& harmonic : input.motion.normal_harmonics) deepest += harmonic.amplitude;
  if (const auto& path = input.motion.path) deepest = *std::max_element(path->normal.begin(), path->normal.end());
  const double a = mdr::inverse_transform(profile, deepest);
  const double rise = mdr::shape_slope(profile, a);
  const bool is_round = input.indenter.shape == Case::Shape::parabola || input.indenter.shape == Case::Shape::sphere;
  if (is_round && rise < least_ratio)
    warnings.push_back(flat_text(input, deepest, a));
  else if (input.indenter.shape == Case::Shape::cone && !(rise >= least_rise && rise <= largest_rise))
    warnings.push_back(
        fmt::format("{}: Indenter / Slope angle = {:.4g} deg, a slope of {:.2g}: {} to {} are usual, as strains are of "
                    "its order and both methods take them for small; it is the angle between the flank and the "
                    "surface, 0 for a flat face",
                    input.file, input.indenter.slope_angle, rise, least_rise, largest_rise));
  else if (!(rise >= least_rise && rise <= largest_rise))
    warnings.push_back(
        fmt::format("{}: at the largest indentation, {:.3g} m, the contact radius is a = {:.3g} m and the indenter "
                    "rises there with "
                    "a slope of {:.2g} (for a parabola a/R), {} to {} are usual; are all lengths in m?",
                    input.file, deepest, a, rise, least_rise, largest_rise));
  const double radius = input.indenter.radius, arc = rise * rise / 6;
  if (input.indenter.shape == Case::Shape::parabola && rise <= largest_rise && arc > arc_matters)
    warnings.push_back(fmt::format(
        "{}: at the largest indentation a/R is {:.2g}; if the parabola stands for a sphere of radius {:.3g} m, the "
        "contact radius of the sphere is smaller by {:.1f} %; Indenter / Shape = sphere has the true arc",
        input.file, rise, radius, 100 * arc));
  if (const auto& path = input.motion.path; path && path->repeats) {
    const double least = *std::min_element(path->normal.begin(), path->normal.end());
    if (least < 0)
      warnings.push_back(
          fmt::format("{}: the indenter lifts off in every period of {}, to {:.3g} m above the surface, and "
                      "nothing sticks for good",
                      input.file, path->file, -least));
  }
  if (!input.motion.path && input.motion.normal_harmonics.empty() &&
      input.motion.normal_amplitude > input.motion.indentation)
    warnings.push_back(fmt::format(
        "{}: the normal amplitude, {:.3g} m, is above the indentation, {:.3g} m: the indenter lifts off in every "
        "cycle, and nothing sticks for good",
        input.file, input.motion.normal_amplitude, input.motion.indentation));
  return warnings;
}

}  // namespace fretval
