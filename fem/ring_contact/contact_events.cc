#include "fem/ring_contact/contact_events.h"

#include <algorithm>
#include <cmath>

#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stencil.h"

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_nearest = 6;
constexpr Eigen::Index n_left_alone = 4;  // events of wide rings next to the tip
constexpr int order_of_events = 3;        // in the width of the rings

/// Sums of neighbouring rows; an odd one at the end is left out.
Eigen::MatrixXd sums_of_pairs(const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd sums(rows.rows() / 2, rows.cols());
  for (Eigen::Index i = 0; i < sums.rows(); ++i) sums.row(i) = rows.row(2 * i) + rows.row(2 * i + 1);
  return sums;
}

/// Of rings of twice the width under uniform pressure, on the same mesh.
Compliance with_wider_rings(const Compliance& compliance) {
  Compliance wide{{},
                  sums_of_pairs(compliance.areas),
                  Eigen::MatrixXd(sums_of_pairs(sums_of_pairs(compliance.matrix).transpose()))};
  for (Eigen::Index i = 0; i <= wide.areas.size(); ++i)
    wide.radii.push_back(compliance.radii[static_cast<std::size_t>(2 * i)]);
  if (compliance.half_space)
    wide.half_space = std::make_shared<const Compliance>(with_wider_rings(*compliance.half_space));
  return wide;
}

ContactEvents plain_contact_events(const Compliance& compliance, const Eigen::VectorXd& profile) {
  const Eigen::Index n = compliance.areas.size();
  const Eigen::MatrixXd factor = cholesky_factor(compliance.matrix);
  const auto& areas = compliance.areas;
  const Eigen::VectorXd by_indentation = factor.triangularView<Eigen::Lower>().solve(areas);
  const Eigen::VectorXd by_profile = factor.triangularView<Eigen::Lower>().solve(areas.cwiseProduct(profile));
  const auto edges = effective_radii(compliance);
  const Eigen::VectorXd& effective = edges.radius;
  ContactEvents events{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), edges.calibration};
  for (Eigen::Index m = 0; m < n; ++m) {
    const auto row = factor.row(m).head(m);
    events.closing_rate[m] = 1 - row.dot(by_indentation.head(m)) / areas[m];
    events.indentation[m] = (profile[m] - row.dot(by_profile.head(m)) / areas[m]) / events.closing_rate[m];
    events.radius[m] = m == 0 ? 0 : (effective[m] + effective[m + 1]) / 2;
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
  auto events = plain_contact_events(compliance, profile);
  const auto wide_rings = with_wider_rings(compliance);
  const Eigen::VectorXd wide_profile =
      sums_of_pairs(compliance.areas.cwiseProduct(profile)).cwiseQuotient(wide_rings.areas);
  extrapolate(events, plain_contact_events(wide_rings, wide_profile));
  return events;
}

}  // namespace fretval::fem
