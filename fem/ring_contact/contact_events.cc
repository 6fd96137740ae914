#include "fem/ring_contact/contact_events.h"

#include <algorithm>
#include <cmath>

#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stencil.h"
#include "fem/ring_contact/wider_rings.h"

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_nearest = 6;
constexpr Eigen::Index n_left_alone = 4;  // events of wide rings next to the tip
constexpr int order_of_events = 3;        // in the width of the rings

ContactEvents plain_contact_events(const Compliance& compliance, const Eigen::VectorXd& profile,
                                   const EffectiveRadii& edges) {
  const Eigen::Index n = compliance.areas.size();
  const Eigen::MatrixXd factor = cholesky_factor(compliance.matrix);
  const auto& areas = compliance.areas;
  const Eigen::VectorXd by_indentation = factor.triangularView<Eigen::Lower>().solve(areas);
  const Eigen::VectorXd by_profile = factor.triangularView<Eigen::Lower>().solve(areas.cwiseProduct(profile));
  ContactEvents events{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), edges.calibration};
  for (Eigen::Index m = 0; m < n; ++m) {
    const auto row = factor.row(m).head(m);
    events.closing_rate[m] = 1 - row.dot(by_indentation.head(m)) / areas[m];
    events.indentation[m] = (profile[m] - row.dot(by_profile.head(m)) / areas[m]) / events.closing_rate[m];
    events.radius[m] = m == 0 ? 0 : edges.of_rings[m];
  }
  return events;
}

/// Richardson's extrapolation of the events from rings of twice the width. Next to an edge of the indenter, and on a
/// flat face, whose rings all touch at once, their difference says nothing; it is far too large then.
void extrapolate(ContactEvents& events, const ContactEvents& wide) {
  constexpr double too_large = 0.05;  // rings
  constexpr double gain = (1 << order_of_events) - 1;
  events.calibration += (events.calibration + wide.calibration) / gain;
  const Eigen::VectorXd radius = events.radius;
  const Eigen::Index n = events.radius.size(), n_wide = wide.radius.size();
  for (Eigen::Index m = 2 * n_left_alone; m < n && n_wide > n_nearest; ++m) {
    const Stencil nearest{wide.radius, wide.indentation,
                          std::clamp<Eigen::Index>(m / 2 - n_nearest / 2, 1, n_wide - n_nearest), n_nearest};
    const Eigen::Index after = std::min(m + 1, n - 1);
    const double rings = radius[after] - radius[m - 1];
    const double slope = (events.indentation[after] - events.indentation[m - 1]) / rings;
    const double off = (events.indentation[m] - nearest(radius[m])) / (slope * gain);
    if (std::abs(off) < too_large * rings / static_cast<double>(after - m + 1)) events.radius[m] -= off;
  }
}

}  // namespace

ContactEvents contact_events(const Compliance& compliance, const Eigen::VectorXd& profile) {
  const auto wide_rings = with_wider_rings(compliance);
  const auto edges = effective_radii(compliance, wide_rings);
  auto events = plain_contact_events(compliance, profile, edges.rings);
  const Eigen::VectorXd wide_profile =
      sums_of_pairs(compliance.areas.cwiseProduct(profile)).cwiseQuotient(wide_rings.areas);
  extrapolate(events, plain_contact_events(wide_rings, wide_profile, edges.wide));
  return events;
}

PunchSeries series_under(const ContactProblem& problem, const Eigen::VectorXd& profile) {
  const auto& series = problem.series;
  if (series.is_half_space()) return series;
  Eigen::VectorXd radii = contact_events(problem.compliance, profile).radius;
  radii[0] = series.radii()[0];  // the depth of a disc of one ring, not the place of the first touch
  return series.with_depths_at(std::move(radii));
}

}  // namespace fretval::fem
