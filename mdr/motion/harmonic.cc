#include "mdr/motion/harmonic.h"

#include <algorithm>
#include <iterator>

#include "mdr/motion/commensurability.h"
#include "mdr/support/trigonometric_maximum.h"

namespace fretval::mdr {

namespace {

double group_maximum(const CommensurateGroup& group, const std::vector<Harmonic>& harmonics) {
  std::vector<TrigonometricTerm> terms;
  for (std::size_t i = 0; i < group.members.size(); ++i) {
    const Harmonic& harmonic = harmonics[group.members[i]];
    terms.push_back({harmonic.amplitude, group.orders[i], harmonic.phase});
  }
  return trigonometric_maximum(terms).value;
}

}  // namespace

double supremum(const std::vector<Harmonic>& harmonics) {
  // A harmonic that does not move must not tie others to its frequency or crowd them out of a group.
  std::vector<Harmonic> moving;
  std::copy_if(harmonics.begin(), harmonics.end(), std::back_inserter(moving),
               [](const Harmonic& harmonic) { return harmonic.amplitude != 0; });
  std::vector<double> frequencies;
  frequencies.reserve(moving.size());
  for (const Harmonic& harmonic : moving) frequencies.push_back(harmonic.frequency);
  double sum = 0;
  for (const CommensurateGroup& group : commensurate_groups(frequencies)) sum += group_maximum(group, moving);
  return sum;
}

}  // namespace fretval::mdr
