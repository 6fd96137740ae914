#include "comparison/case/test_duration.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "comparison/case/oscillations.h"
#include "mdr/motion/commensurability.h"
#include "mdr/rheology/branch_merging.h"

namespace fretval {
namespace {

constexpr double near = 3;  // times longer or shorter
constexpr double merging_share = 0.1, tolerance_without = 1e-3;
constexpr double harmonics = 300;    // of the fastest oscillation, that the response to it still shows
constexpr double rows_in_pass = 30;  // of a path, whose shape takes as many frequencies

/// The lowest and the highest one.
std::pair<double, double> frequencies_of(const Case::Motion& motion) {
  if (motion.path) return {1 / motion.path->duration(), rows_in_pass / motion.path->duration()};
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const auto& one : oscillations_of(motion)) {
    lowest = std::min(lowest, one.frequency);
    highest = std::max(highest, one.frequency);
  }
  return {lowest, highest};
}

/// The slowest frequency that a periodic state has besides rest.
double slowest_shown(const Case::Motion& motion) {
  if (motion.path) return (motion.path->repeats ? 1 : 0.01) / motion.path->duration();
  std::vector<double> frequencies;
  for (const auto& one : oscillations_of(motion)) frequencies.push_back(one.frequency);
  const auto groups = mdr::commensurate_groups(frequencies);
  return groups.size() == 1 ? groups[0].base_frequency : frequencies_of(motion).first;
}

bool has_frequencies(const Case::Motion& motion) {
  return motion.normal_frequency > 0 && motion.tangential_frequency > 0;
}

}  // namespace

void limit_to_test(double seconds, Case& input) {
  auto& body = input.elastomer;
  Case::TestDuration test{seconds, body.relaxed_modulus, body.branch_moduli, body.branch_times, body.viscosity};
  mdr::PronyBody seen{body.relaxed_modulus, {}, {}, body.viscosity};
  for (std::size_t i = 0; i < body.branch_times.size(); ++i) {
    const double time = body.branch_times[i], modulus = body.branch_moduli[i];
    if (time > seconds / near && time < seconds * near) test.near_times.push_back(time);
    if (time > seconds) {
      seen.relaxed_modulus += modulus;
      ++test.n_slow;
    } else {
      seen.branch_moduli.push_back(modulus);
      seen.branch_times.push_back(time);
    }
  }
  if (has_frequencies(input.motion) && seen.relaxed_modulus > 0) {
    const double lowest = slowest_shown(input.motion), highest = frequencies_of(input.motion).second;
    const double tolerance = merging_share * (input.tolerance > 0 ? input.tolerance : tolerance_without);
    const auto merged = mdr::merged(seen, lowest, harmonics * highest, tolerance);
    seen = merged.body;
    test.n_fast = merged.n_merged;
    test.merging_error = merged.error;
  }
  body.relaxed_modulus = seen.relaxed_modulus;
  body.branch_moduli = std::move(seen.branch_moduli);
  body.branch_times = std::move(seen.branch_times);
  body.test_duration = std::move(test);
}

Case with_duration_times(double factor, Case input) {
  auto& body = input.elastomer;
  const auto test = *body.test_duration;
  body.relaxed_modulus = test.relaxed_modulus;
  body.branch_moduli = test.branch_moduli;
  body.branch_times = test.branch_times;
  body.viscosity = test.viscosity;
  body.test_duration.reset();
  limit_to_test(factor * test.seconds, input);
  return input;
}

std::vector<double> times_slower_than(double n_cycles, const Case& input) {
  std::vector<double> times;
  if (input.elastomer.test_duration || !has_frequencies(input.motion)) return times;
  const double longest = n_cycles / frequencies_of(input.motion).first;
  for (const double time : input.elastomer.branch_times)
    if (time > longest) times.push_back(time);
  std::sort(times.begin(), times.end());
  return times;
}

std::string too_slow_for_forces(const Case& input) {
  const auto& motion = input.motion;
  const bool by_force = motion.path
                            ? motion.path->repeats && (motion.path->normal_force || motion.path->tangential_force)
                            : motion.normal_force || motion.tangential_force;
  const auto slow = by_force ? times_slower_than(many_cycles, input) : std::vector<double>{};
  if (slow.empty()) return "";
  return fmt::format(
      "under prescribed forces all cycles up to the periodic state are stepped, of which there are too many where "
      "branches relax in up to {:.2g} s; set Elastomer / Duration of the test to how long the test lasts, so that "
      "slower branches count as springs",
      slow.back());
}

}  // namespace fretval
