#include "fem/ring_contact/stick_zone/largest_indentation.h"

#include <algorithm>
#include <utility>

#include "fem/support/constants.h"

namespace fretval::fem {

LargestIndentation largest_indentation(const ContactProblem& problem, const RelaxationModel& relaxation,
                                       const NormalHistory& history) {
  constexpr int enough_cycles = 2;
  double dt = 2 * pi / history.steps_per_cycle, instantaneous = RelaxationStep(relaxation, dt).instantaneous();
  double error = 0, largest = 0;
  for (int k = 0; k < enough_cycles * history.steps_per_cycle; ++k) {
    const Eigen::Index step = k % history.steps_per_cycle;
    if (!history.pieces.empty()) {
      const double duration = history.pieces[static_cast<std::size_t>(step)].duration();
      if (std::exchange(dt, duration) != duration) instantaneous = RelaxationStep(relaxation, dt).instantaneous();
    }
    const double force = history.force_uncertainty[step] + history.force_beyond_uncertainty[step],
                 moved = force / (problem.series.force_per_radius() * history.contact_radius[step]);
    error += (moved - relaxation.relaxed * error) / instantaneous;
    largest = std::max(largest, error);
  }
  return {history.largest_indentation, largest};
}

}  // namespace fretval::fem
