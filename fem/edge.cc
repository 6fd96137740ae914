#include "fem/edge.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fem/solver_error.h"
#include "fem/stencil.h"

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_fitted_events = 6;

/// Where the polynomial fitted to y(x) (least squares) vanishes, between the last but one x and a limit; empty if it
/// does not. y falls.
std::optional<double> root_beyond(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree, double limit) {
  const Eigen::Index n = x.size();
  const double centre = x[n - 1], scale = centre - x[0];
  Eigen::MatrixXd powers(n, degree + 1);
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = 0; k <= degree; ++k) powers(i, k) = std::pow((x[i] - centre) / scale, k);
  const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(y);
  const auto value = [&](double at) {
    double sum = 0;
    for (int k = degree; k >= 0; --k) sum = sum * (at - centre) / scale + c[k];
    return sum;
  };
  return root_between(value, x[n - 2], limit);
}

bool has_equal_rings(const Compliance& compliance) {
  const auto& radii = compliance.radii;
  for (std::size_t m = 1; m < radii.size(); ++m)
    if (std::abs(radii[m] - radii[m - 1] - radii[1]) > 1e-9 * radii[1]) return false;
  return true;
}

/// Radius at an indentation between events m - 1 and m, by the polynomial through the nearest events.
double radius_at(const ContactEvents& events, Eigen::Index m, double indentation) {
  const Eigen::Index n = std::min(n_fitted_events, events.radius.size());
  const Eigen::Index begin = std::clamp<Eigen::Index>(m - n / 2, 0, events.radius.size() - n);
  return Stencil{events.indentation, events.radius, begin, n}(indentation);
}

}  // namespace

EffectiveRadii effective_radii(const Compliance& compliance) {
  const Eigen::Index n = compliance.areas.size();
  // Force of a unit indentation on rings 0..m-1 = |L_m^{-1} A_m|^2: one forward substitution serves every m.
  const Eigen::VectorXd half = cholesky_factor(compliance).triangularView<Eigen::Lower>().solve(compliance.areas);
  Eigen::VectorXd force(n + 1);
  Eigen::MatrixXd terms(n + 1, 3);
  force[0] = 0;
  terms.row(0).setZero();
  for (Eigen::Index m = 1; m <= n; ++m) {
    force[m] = force[m - 1] + half[m - 1] * half[m - 1];
    const double radius = compliance.radii[m], width = radius - compliance.radii[m - 1];
    terms.row(m) << radius, width, width * width / radius;
  }
  // The innermost discs are of too few rings. Under rings that differ, the third term would fit their differences.
  const Eigen::Index begin = n / 4, count = std::max<Eigen::Index>(n / 2, 3);
  const auto fitted = terms.middleRows(begin, count).leftCols(has_equal_rings(compliance) ? 3 : 2);
  const Eigen::VectorXd fit = fitted.colPivHouseholderQr().solve(force.segment(begin, count));
  const double scatter = (fitted * fit - force.segment(begin, count)).cwiseAbs().maxCoeff() / fit[0];
  return {force / fit[0], scatter};
}

EdgeRadius largest_contact_radius(const Eigen::VectorXd& smallest_gap, const ContactEvents& events) {
  Eigen::Index m = 0;
  while (m < smallest_gap.size() && smallest_gap[m] <= 0) ++m;
  if (m < 2 || m >= smallest_gap.size()) throw SolverError("the contact has no edge inside the contact line");
  const double deepest = events.indentation[m] - smallest_gap[m] / events.closing_rate[m];
  return {radius_at(events, m, deepest), events.radius[m] - events.radius[m - 1]};
}

EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& reserve, Eigen::Index n_stuck) {
  if (n_stuck == 0) return {0, compliance.radii[1]};
  const auto [effective, scatter] = effective_radii(compliance);
  const double width = compliance.radii[n_stuck] - compliance.radii[n_stuck - 1];
  if (n_stuck < 3) return {effective[n_stuck], width};
  const Eigen::Index n = std::min(n_stuck, n_fitted_events);
  Eigen::VectorXd radius(n), load(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index j = n_stuck - n + k;
    radius[k] = (effective[j] + effective[j + 1]) / 2;
    load[k] = reserve[j];
  }
  // The next ring has slipped. Next to a sharp edge of the indenter the reserve falls too steeply for the fit to see
  // it.
  const double next =
      n_stuck + 1 < effective.size() ? (effective[n_stuck] + effective[n_stuck + 1]) / 2 : effective[n_stuck];
  const double limit = next + width / 4;
  const auto root = [&](Eigen::Index n_events, Eigen::Index degree) {
    const Eigen::Index m = std::min(n, n_events);
    return root_beyond(radius.tail(m), load.tail(m), static_cast<int>(std::min(m - 1, degree)), limit);
  };
  const auto fitted = root(4, 2), other = root(n_fitted_events, 3);
  if (!fitted || !other) return {(radius[n - 1] + next) / 2, width};
  const double relative_width = width / compliance.radii.back();
  return {*fitted, 2 * std::abs(*fitted - *other) + scatter + relative_width * relative_width * width};
}

double touch_indentation(const Compliance& compliance, const Eigen::VectorXd& profile, Eigen::Index n_pressed,
                         Eigen::Index n_flank) {
  const Eigen::LLT<Eigen::MatrixXd> pressed(compliance.matrix.topLeftCorner(n_pressed, n_pressed));
  const Eigen::VectorXd areas = compliance.areas.head(n_pressed);
  const Eigen::MatrixXd coupling = compliance.matrix.block(n_pressed, 0, n_flank, n_pressed);
  const Eigen::VectorXd flank_areas = compliance.areas.segment(n_pressed, n_flank);
  const double closing = flank_areas.sum() - (coupling * pressed.solve(areas)).sum();
  const double height = flank_areas.dot(profile.segment(n_pressed, n_flank)) -
                        (coupling * pressed.solve(areas.cwiseProduct(profile.head(n_pressed)))).sum();
  return height / closing;
}

}  // namespace fretval::fem
