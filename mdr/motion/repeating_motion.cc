#include "mdr/motion/repeating_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {
namespace {

int greatest_divisor(const std::vector<int>& orders) {
  int divisor = 0;
  for (const int order : orders) divisor = std::gcd(divisor, order);
  return std::max(divisor, 1);
}

int lowest(const CommonCycle& cycle) {
  int order = cycle.highest_order();
  for (const auto* orders : {&cycle.normal_orders, &cycle.tangential_orders})
    for (const int other : *orders)
      if (other > 0) order = std::min(order, other);
  return order;
}

RepeatingMotion creeping(const HarmonicMotion& motion, const CommonCycle& cycle, int n_oscillations) {
  const int repeats = std::lcm(greatest_divisor(cycle.normal_orders), greatest_divisor(cycle.tangential_orders)),
            n_cycles = (n_oscillations + cycle.highest_order() - 1) / cycle.highest_order();
  const double duration = 1 / cycle.frequency;
  return {motion, duration, n_cycles, duration / repeats, n_cycles * lowest(cycle)};
}

/// How often each group of commensurate harmonics repeats in a cycle, and whether that cycle creeps.
struct Rounding {
  double cycle_frequency;
  std::vector<int> repeats;
  int highest_order;
  bool creeps;
};

double distance(const std::vector<HarmonicGroup>& groups, const Rounding& rounding, int n_oscillations) {
  double off = 0, softness = 0;
  long common = 1;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto repeats = static_cast<double>(rounding.repeats[g]);
    off += std::abs(groups[g].base_frequency / (repeats * rounding.cycle_frequency) - 1);
    softness += 1 / (repeats * repeats);
    common = std::lcm(common, long{rounding.repeats[g]});
  }
  double lag = pi / static_cast<double>(common);
  if (rounding.creeps) lag *= pi * rounding.highest_order / n_oscillations;
  return off + lag * lag / 2 / softness;
}

/// The frequencies rounded to those of a cycle of q periods of the first group.
Rounding rounding_to(int q, const std::vector<HarmonicGroup>& groups, int n_oscillations) {
  constexpr int cycles_to_creep = 12;
  Rounding rounding{groups[0].base_frequency / q, {}, 0, false};
  for (const auto& group : groups) {
    const auto repeats = std::max(static_cast<int>(std::lround(group.base_frequency / rounding.cycle_frequency)), 1);
    rounding.repeats.push_back(repeats);
    rounding.highest_order = std::max(rounding.highest_order, repeats * group.highest_order());
  }
  rounding.creeps = are_the_directions(groups) && rounding.highest_order * cycles_to_creep <= n_oscillations;
  return rounding;
}

RepeatingMotion rounded(HarmonicMotion motion, int n_oscillations) {
  motion = without_still_harmonics(motion);
  const auto groups = harmonic_groups(motion);
  auto best = rounding_to(1, groups, n_oscillations);
  double least = distance(groups, best, n_oscillations);
  for (int q = 2;; ++q) {
    const auto other = rounding_to(q, groups, n_oscillations);
    if (other.highest_order > n_oscillations) break;
    const double its_distance = distance(groups, other, n_oscillations);
    if (its_distance >= least) continue;
    best = other;
    least = its_distance;
  }
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const auto& [normal, place, order] : groups[g].members)
      (normal ? motion.normal : motion.tangential)[place].frequency = best.repeats[g] * order * best.cycle_frequency;
  const auto cycle = common_cycle(motion).value();
  if (best.creeps) return creeping(motion, cycle, n_oscillations);
  motion.phase_locked = true;
  return {motion, 1 / cycle.frequency, 1, 0, lowest(cycle)};
}

}  // namespace

int RepeatingMotion::steps_with(int steps_per_oscillation) const {
  return static_cast<int>(std::lround(steps_per_oscillation * highest_frequency(motion) * period()));
}

double RepeatingMotion::lag_at(double time) const {
  if (lag == 0) return 0;
  return lag / 2 * (1 - std::cos(2 * pi * time / period()));
}

double RepeatingMotion::lag_rate_at(double time) const {
  if (lag == 0) return 0;
  return lag / 2 * (2 * pi / period()) * std::sin(2 * pi * time / period());
}

RepeatingMotion repeating_motion(const HarmonicMotion& motion, int n_oscillations) {
  validate(motion);
  require_within("number of oscillations", n_oscillations, 1, 1e6);
  const auto cycle = common_cycle(motion);
  if (!cycle) return rounded(motion, n_oscillations);
  if (!motion.phase_locked) return creeping(motion, *cycle, n_oscillations);
  return {motion, 1 / cycle->frequency};
}

}  // namespace fretval::mdr
