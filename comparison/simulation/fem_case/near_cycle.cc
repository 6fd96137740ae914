#include "comparison/simulation/fem_case/near_cycle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "fem/motion/motion.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

constexpr int cycles_to_creep = 12;

/// The directions of a motion that has a long cycle are groups of their own.
std::vector<mdr::HarmonicGroup> groups_to_round(const mdr::HarmonicMotion& motion) {
  auto groups = mdr::harmonic_groups(motion);
  if (groups.size() > 1) return groups;
  groups = mdr::harmonic_groups({motion.indentation, motion.normal, {}});
  const auto others = mdr::harmonic_groups({motion.indentation, {}, motion.tangential});
  groups.insert(groups.end(), others.begin(), others.end());
  return groups;
}

/// To q periods of the first group.
NearCycle rounded_to(int q, const std::vector<mdr::HarmonicGroup>& groups, const mdr::HarmonicMotion& motion,
                     const Stiffening& stiffening, const Demands& demands, int n_creep_cycles) {
  NearCycle near{{groups[0].base_frequency / q, std::vector<int>(motion.normal.size()),
                  std::vector<int>(motion.tangential.size())},
                 false,
                 0,
                 0};
  int common = 1;
  double softness = 0;
  for (const auto& group : groups) {
    const int repeats = std::max(static_cast<int>(std::round(group.base_frequency / near.cycle.frequency)), 1);
    common = std::lcm(common, repeats);
    double curvature = 0;
    for (const auto& [is_normal, place, order_in_group] : group.members) {
      const int order = repeats * order_in_group;
      (is_normal ? near.cycle.normal_orders : near.cycle.tangential_orders)[place] = order;
      const auto& [amplitude, frequency, phase, across] = (is_normal ? motion.normal : motion.tangential)[place];
      const double rounded = demands.scaled && !is_normal ? frequency : order * near.cycle.frequency,
                   demand = (is_normal ? demands.normal : demands.tangential)(amplitude, rounded),
                   off = demand * std::abs(stiffening(frequency) / stiffening(rounded) - 1);
      curvature += demand * order * order;
      near.error_of_demand += off;
      if (is_normal) near.error_of_normal += off;
    }
    softness += 1 / curvature;
  }
  if (groups.size() == 1) return near;
  const int highest = near.cycle.highest_order(), n_oscillations = 2 * n_creep_cycles;
  near.creeps = mdr::are_the_directions(groups) && highest <= n_oscillations / cycles_to_creep;
  const double lag = fem::pi / common * (near.creeps ? fem::pi / fem::creep_period(n_creep_cycles, highest) : 1);
  near.error_of_demand += lag * lag / 2 / softness;
  return near;
}

/// Two directions, the normal one first.
void bring_together(std::vector<mdr::HarmonicGroup>& groups) {
  // Any ratio would do: those that are near are kept, to be stepped as they are.
  constexpr double widest = 8, golden = 1.618033988749895;
  const double normal = groups[0].base_frequency;
  double& tangential = groups[1].base_frequency;
  if (tangential > widest * normal) tangential = golden * normal;
  if (tangential < normal / widest) tangential = normal / golden;
}

}  // namespace

NearCycle near_cycle(const mdr::HarmonicMotion& motion, const Stiffening& stiffening, const Demands& demands,
                     int n_creep_cycles) {
  auto groups = groups_to_round(motion);
  if (groups.size() > 2) throw std::invalid_argument("near cycle of more than two independent frequencies");
  if (demands.scaled && mdr::are_the_directions(groups)) bring_together(groups);
  const auto candidate = [&](int q) { return rounded_to(q, groups, motion, stiffening, demands, n_creep_cycles); };
  auto nearest = candidate(1);
  for (int q = 2;; ++q) {
    const auto other = candidate(q);
    if (other.cycle.highest_order() > 2 * n_creep_cycles) return nearest;
    if (other.error_of_demand < nearest.error_of_demand) nearest = other;
  }
}

}  // namespace fretval
