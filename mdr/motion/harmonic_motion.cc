#include "mdr/motion/harmonic_motion.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>

#include "mdr/motion/commensurability.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/trigonometric_maximum.h"

namespace fretval::mdr {

namespace {

void validate_direction(const std::vector<Harmonic>& harmonics, const std::string& direction) {
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const std::string where = " of " + direction + " harmonic " + std::to_string(i + 1);
    require_non_negative("amplitude" + where, harmonics[i].amplitude);
    require_positive("frequency" + where, harmonics[i].frequency);
    require_finite("phase" + where, harmonics[i].phase);
  }
}

std::vector<Harmonic> moving(const std::vector<Harmonic>& harmonics) {
  std::vector<Harmonic> those;
  std::copy_if(harmonics.begin(), harmonics.end(), std::back_inserter(those),
               [](const Harmonic& harmonic) { return harmonic.amplitude > 0; });
  if (those.empty() && !harmonics.empty()) those.push_back(harmonics.front());
  return those;
}

}  // namespace

bool moves_across(const HarmonicMotion& motion) {
  return std::any_of(motion.tangential.begin(), motion.tangential.end(),
                     [](const Harmonic& harmonic) { return harmonic.across && harmonic.amplitude > 0; });
}

void validate(const HarmonicMotion& motion) {
  require_positive("indentation", motion.indentation);
  validate_direction(motion.normal, "normal");
  validate_direction(motion.tangential, "tangential");
}

HarmonicMotion harmonic_motion(const Motion& motion) {
  validate(motion);
  return {motion.indentation,
          {{motion.normal_amplitude, motion.normal_frequency, 0}},
          {{motion.tangential_amplitude, motion.tangential_frequency, motion.phase.value_or(0)}},
          motion.phase.has_value()};
}

std::optional<Motion> one_harmonic_each(const HarmonicMotion& motion) {
  validate(motion);
  const auto [indentation, normal, tangential, locked] = without_still_harmonics(motion);
  if (normal.size() != 1 || tangential.size() != 1 || normal[0].phase != 0) return std::nullopt;
  return Motion{
      indentation,         normal[0].amplitude,     tangential[0].amplitude,
      normal[0].frequency, tangential[0].frequency, locked ? std::optional(tangential[0].phase) : std::nullopt};
}

HarmonicMotion without_still_harmonics(const HarmonicMotion& motion) {
  return {motion.indentation, moving(motion.normal), moving(motion.tangential), motion.phase_locked};
}

double highest_frequency(const HarmonicMotion& motion) {
  double highest = 0;
  for (const auto* harmonics : {&motion.normal, &motion.tangential})
    for (const Harmonic& harmonic : *harmonics) highest = std::max(highest, harmonic.frequency);
  return highest;
}

double lowest_frequency(const HarmonicMotion& motion) {
  double lowest = highest_frequency(motion);
  for (const auto* harmonics : {&motion.normal, &motion.tangential})
    for (const Harmonic& harmonic : *harmonics) lowest = std::min(lowest, harmonic.frequency);
  return lowest;
}

int CommonCycle::highest_order() const {
  int highest = 1;
  for (const auto* orders : {&normal_orders, &tangential_orders})
    for (const int order : *orders) highest = std::max(highest, order);
  return highest;
}

std::optional<CommonCycle> common_cycle(const HarmonicMotion& motion) {
  CommonCycle cycle{motion.normal.empty() ? 0 : motion.normal.front().frequency, std::vector<int>(motion.normal.size()),
                    std::vector<int>(motion.tangential.size())};
  const auto groups = harmonic_groups(motion);
  if (groups.empty()) return cycle;
  if (groups.size() != 1) return std::nullopt;
  cycle.frequency = groups[0].base_frequency;
  for (const auto& [normal, place, order] : groups[0].members)
    (normal ? cycle.normal_orders : cycle.tangential_orders)[place] = order;
  return cycle;
}

int HarmonicGroup::highest_order() const {
  int highest = 1;
  for (const auto& member : members) highest = std::max(highest, member.order);
  return highest;
}

std::vector<HarmonicGroup> harmonic_groups(const HarmonicMotion& motion) {
  std::vector<HarmonicGroup::Member> moving;
  std::vector<double> frequencies;
  for (const auto* harmonics : {&motion.normal, &motion.tangential})
    for (std::size_t place = 0; place < harmonics->size(); ++place) {
      const Harmonic& harmonic = (*harmonics)[place];
      if (harmonic.amplitude == 0) continue;
      moving.push_back({harmonics == &motion.normal, place, 1});
      frequencies.push_back(harmonic.frequency);
    }
  std::vector<HarmonicGroup> groups;
  for (const auto& [base_frequency, members, orders] : commensurate_groups(frequencies)) {
    groups.push_back({base_frequency, {}});
    for (std::size_t i = 0; i < members.size(); ++i) {
      groups.back().members.push_back(moving[members[i]]);
      groups.back().members.back().order = orders[i];
    }
  }
  return groups;
}

bool are_the_directions(const std::vector<HarmonicGroup>& groups) {
  const auto all = [](const HarmonicGroup& group, bool normal) {
    return std::all_of(group.members.begin(), group.members.end(),
                       [normal](const auto& member) { return member.normal == normal; });
  };
  return groups.size() == 2 && all(groups[0], true) && all(groups[1], false);
}

HarmonicMotion from_largest_indentation(HarmonicMotion motion) {
  validate(motion);
  for (const auto& group : harmonic_groups(motion)) {
    std::vector<TrigonometricTerm> terms;
    int repeats = 0;
    for (const auto& [normal, place, order] : group.members) {
      if (!normal) continue;
      terms.push_back({motion.normal[place].amplitude, order, motion.normal[place].phase});
      repeats = std::gcd(repeats, order);
    }
    if (terms.empty() || (terms.size() == 1 && terms[0].phase == 0)) continue;
    for (auto& term : terms) term.order /= repeats;
    const double time = trigonometric_maximum(terms).angle / angular_frequency(repeats * group.base_frequency);
    for (const auto& [normal, place, order] : group.members) {
      Harmonic& harmonic = (normal ? motion.normal : motion.tangential)[place];
      harmonic.phase += angular_frequency(harmonic.frequency) * time;
    }
  }
  return motion;
}

double maximum_indentation(const HarmonicMotion& motion) {
  validate(motion);
  return motion.indentation + supremum(motion.normal);
}

double minimum_indentation(const HarmonicMotion& motion) {
  validate(motion);
  std::vector<Harmonic> reversed = motion.normal;
  for (Harmonic& harmonic : reversed) harmonic.amplitude = -harmonic.amplitude;
  return motion.indentation - supremum(reversed);
}

}  // namespace fretval::mdr
