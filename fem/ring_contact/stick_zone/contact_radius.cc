#include "fem/ring_contact/stick_zone/contact_radius.h"

#include <algorithm>

#include "fem/ring_contact/stencil.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_nearest_events = 6;

/// Radius at an indentation between events m - 1 and m, by the polynomial through the nearest events.
double radius_at(const ContactEvents& events, Eigen::Index m, double indentation) {
  const Eigen::Index n = std::min(n_nearest_events, events.radius.size());
  const Eigen::Index begin = std::clamp<Eigen::Index>(m - n / 2, 0, events.radius.size() - n);
  return Stencil{events.indentation, events.radius, begin, n}(indentation);
}

}  // namespace

EdgeRadius largest_contact_radius(const Eigen::VectorXd& smallest_gap, const ContactEvents& events) {
  Eigen::Index m = 0;
  while (m < smallest_gap.size() && smallest_gap[m] <= 0) ++m;
  if (m >= smallest_gap.size()) throw SolverError("the contact has no edge inside the contact line");
  if (m < 2)
    throw SolverError(
        "fewer than two rings touch at the largest indentation: the surface of a body that creeps for long "
        "stays where the indenter has pressed it, and no contact is left to read");
  const double deepest = events.indentation[m] - smallest_gap[m] / events.closing_rate[m];
  return {radius_at(events, m, deepest), events.radius[m] - events.radius[m - 1]};
}

}  // namespace fretval::fem
