#include "comparison/simulation/fem_case/near_cycle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fem/motion/motion.h"
#include "fem/support/constants.h"
#include "mdr/motion/commensurability.h"

namespace fretval {
namespace {

/// A harmonic that moves, and where it stands in the cycle.
struct Member {
  mdr::Harmonic harmonic;
  const Demand* demand;
  bool normal;
  std::size_t place;
  int order_in_group = 1;
};

struct Group {
  double base_frequency;
  std::vector<Member> members;
};

std::vector<Member> moving(const std::vector<mdr::Harmonic>& harmonics, bool normal, const Demand& demand) {
  std::vector<Member> members;
  for (std::size_t i = 0; i < harmonics.size(); ++i)
    if (harmonics[i].amplitude > 0) members.push_back({harmonics[i], &demand, normal, i});
  return members;
}

std::vector<Group> grouped(const std::vector<Member>& members) {
  std::vector<double> frequencies;
  for (const auto& member : members) frequencies.push_back(member.harmonic.frequency);
  std::vector<Group> groups;
  for (const auto& [base_frequency, places, orders] : mdr::commensurate_groups(frequencies)) {
    groups.push_back({base_frequency, {}});
    for (std::size_t i = 0; i < places.size(); ++i) {
      groups.back().members.push_back(members[places[i]]);
      groups.back().members.back().order_in_group = orders[i];
    }
  }
  return groups;
}

/// The directions of a motion that has a long cycle are groups of their own.
std::vector<Group> groups_of(const mdr::HarmonicMotion& motion, const Demand& normal, const Demand& tangential) {
  const auto falling = moving(motion.normal, true, normal), sliding = moving(motion.tangential, false, tangential);
  auto all = falling;
  all.insert(all.end(), sliding.begin(), sliding.end());
  auto groups = grouped(all);
  if (groups.size() != 1 || falling.empty() || sliding.empty()) return groups;
  groups = grouped(falling);
  const auto others = grouped(sliding);
  groups.insert(groups.end(), others.begin(), others.end());
  return groups;
}

bool is_one_direction(const Group& group) {
  return std::all_of(group.members.begin(), group.members.end(),
                     [&](const Member& member) { return member.normal == group.members.front().normal; });
}

/// Demand of a group that repeats so often in a cycle of this frequency in Hz.
struct GroupDemand {
  double curvature = 0, rounding = 0, rounding_of_normal = 0;

  GroupDemand(const Group& group, const Stiffening& stiffening, int repeats, double cycle) {
    for (const auto& member : group.members) {
      const int order = repeats * member.order_in_group;
      const auto& [amplitude, frequency, phase] = member.harmonic;
      const double rounded = (*member.demand)(amplitude, order * cycle),
                   off = rounded * std::abs(stiffening(frequency) / stiffening(order * cycle) - 1);
      curvature += rounded * order * order;
      rounding += off;
      if (member.normal) rounding_of_normal += off;
    }
  }
};

}  // namespace

NearCycle near_cycle(const mdr::HarmonicMotion& motion, const Stiffening& stiffening, const Demand& normal,
                     const Demand& tangential, int n_creep_cycles) {
  const int n_oscillations = 2 * n_creep_cycles, slow_enough_to_creep = n_oscillations / 12;
  const auto groups = groups_of(motion, normal, tangential);
  if (groups.size() > 2) throw std::invalid_argument("near cycle of more than two independent frequencies");
  const bool may_creep = std::all_of(groups.begin(), groups.end(), is_one_direction);
  std::optional<NearCycle> nearest;
  for (int q = 1;; ++q) {
    mdr::CommonCycle cycle{groups[0].base_frequency / q, std::vector<int>(motion.normal.size()),
                           std::vector<int>(motion.tangential.size())};
    int common = 1;
    std::vector<GroupDemand> demands;
    for (const auto& group : groups) {
      const int repeats = std::max(static_cast<int>(std::round(group.base_frequency / cycle.frequency)), 1);
      common = std::lcm(common, repeats);
      demands.emplace_back(group, stiffening, repeats, cycle.frequency);
      for (const auto& [harmonic, demand, is_normal, place, order] : group.members)
        (is_normal ? cycle.normal_orders : cycle.tangential_orders)[place] = repeats * order;
    }
    if (nearest && cycle.highest_order() > n_oscillations) return *nearest;
    double lag = fem::pi / common, error = 0, error_of_normal = 0;
    const bool creeps = may_creep && cycle.highest_order() <= slow_enough_to_creep;
    if (creeps) lag *= fem::pi / fem::creep_period(n_creep_cycles, cycle.highest_order());
    for (const auto& demand : demands) {
      error += demand.rounding;
      error_of_normal += demand.rounding_of_normal;
    }
    if (demands.size() == 2) {
      const double a = demands[0].curvature, b = demands[1].curvature;
      error += a * b / (a + b) * lag * lag / 2;
    }
    if (!nearest || error < nearest->error_of_demand) nearest = NearCycle{cycle, creeps, error, error_of_normal};
  }
}

}  // namespace fretval
