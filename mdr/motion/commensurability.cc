#include "mdr/motion/commensurability.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

const double ratio_tolerance = 1e-12;

// The group with one more member, its orders scaled to the finer base; empty: an order would become too large.
std::optional<CommensurateGroup> joined(const CommensurateGroup& group, std::size_t member, FrequencyRatio to_first) {
  const long first_order = group.orders.front();
  const long common = std::lcm(first_order, long{to_first.denominator});
  const long refinement = common / first_order;
  const long order = common / to_first.denominator * to_first.numerator;
  const long largest = *std::max_element(group.orders.begin(), group.orders.end()) * refinement;
  if (std::max(largest, order) > largest_order) return std::nullopt;
  CommensurateGroup result = group;
  result.base_frequency /= refinement;
  for (int& other : result.orders) other *= refinement;
  result.members.push_back(member);
  result.orders.push_back(order);
  return result;
}

bool join_any(std::vector<CommensurateGroup>& groups, const std::vector<double>& frequencies, std::size_t member) {
  for (CommensurateGroup& group : groups) {
    const auto ratio = frequency_ratio(frequencies[member] / frequencies[group.members.front()]);
    if (!ratio) continue;
    auto larger = joined(group, member, *ratio);
    if (!larger) continue;
    group = std::move(*larger);
    return true;
  }
  return false;
}

}  // namespace

std::optional<FrequencyRatio> frequency_ratio(double ratio) {
  require_positive("frequency ratio", ratio);
  // Convergents p/q of the continued fraction, and the ones before them.
  double p = 1, q = 0, last_p = 0, last_q = 1;
  double rest = ratio;
  while (true) {
    const double digit = std::floor(rest);
    const double next_p = digit * p + last_p, next_q = digit * q + last_q;
    if (next_p > largest_order || next_q > largest_order) return std::nullopt;
    last_p = p, last_q = q, p = next_p, q = next_q;
    if (std::abs(ratio * q - p) <= ratio_tolerance * p) return FrequencyRatio{int(p), int(q)};
    rest = 1 / (rest - digit);
  }
}

std::vector<CommensurateGroup> commensurate_groups(const std::vector<double>& frequencies) {
  std::vector<CommensurateGroup> groups;
  for (std::size_t member = 0; member < frequencies.size(); ++member) {
    require_positive("frequency", frequencies[member]);
    if (!join_any(groups, frequencies, member)) groups.push_back({frequencies[member], {member}, {1}});
  }
  return groups;
}

}  // namespace fretval::mdr
