#include "comparison/simulation/normal_part.h"

#include "fem/ring_contact/static_contact.h"

namespace fretval {

fem::HistoryControl control_of(const FemCase& fem) {
  constexpr int most_cycles = 800;
  const int most_after_ramp = fem.without_short_cycle && fem.motion.locked ? fem::most_long_periods : most_cycles;
  return {fem.steps_per_cycle(), fem.motion.cycles_of_ramp() + most_after_ramp, fem.resolution.periodicity};
}

NormalPart normal_part(const ContactProblems& problems, const FemCase& fem, NormalStore& normals) {
  auto profile = fem::ring_means(problems.normal.compliance, fem.profile);
  auto record = normals.find_or_make(fem, problems.normal, problems.tangential ? &problems.tangential->series : nullptr,
                                     profile, control_of(fem));
  auto contact_radius = read_contact_radius(problems.normal, fem, profile, record->history);
  return {std::move(record), std::move(profile), contact_radius};
}

}  // namespace fretval
