#include "fem/edge.h"

#include <algorithm>
#include <cmath>

#include "fem/solver_error.h"

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_skipped = 3;

Eigen::MatrixXd cholesky_factor(const Compliance& compliance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(compliance.matrix);
  if (factor.info() != Eigen::Success) throw SolverError("the contact compliance is not positive definite");
  return factor.matrixL();
}

struct Line {
  double intercept, slope;
};

Line fit_line(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const double x_mean = x.mean(), y_mean = y.mean();
  const double slope =
      (x.array() - x_mean).matrix().dot((y.array() - y_mean).matrix()) / (x.array() - x_mean).square().sum();
  return {y_mean - slope * x_mean, slope};
}

/// Root beyond the last point of the polynomial of the given degree through y(x) (least squares).
double extrapolated_root(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int degree) {
  const double centre = x[x.size() - 1], scale = x[x.size() - 1] - x[0];
  Eigen::MatrixXd powers(x.size(), degree + 1);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    for (int k = 0; k <= degree; ++k) powers(i, k) = std::pow((x[i] - centre) / scale, k);
  const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(y);
  double root = -c[0] / c[1];
  for (int iteration = 0; iteration < 20 && degree > 1; ++iteration)
    root -= (c[0] + root * (c[1] + root * c[2])) / (c[1] + 2 * root * c[2]);
  return centre + scale * root;
}

}  // namespace

Eigen::VectorXd effective_radii(const Compliance& compliance) {
  const Eigen::Index n = compliance.areas.size();
  // Force of a unit indentation on rings 0..m-1 = |L_m^{-1} A_m|^2: one forward substitution serves every m.
  const Eigen::VectorXd half = cholesky_factor(compliance).triangularView<Eigen::Lower>().solve(compliance.areas);
  Eigen::VectorXd force(n + 1), radius(n + 1);
  force[0] = 0;
  for (Eigen::Index m = 0; m < n; ++m) force[m + 1] = force[m] + half[m] * half[m];
  for (Eigen::Index m = 0; m <= n; ++m) radius[m] = compliance.radii[m];
  const Eigen::Index begin = n / 4, count = std::max<Eigen::Index>(n / 2, 2);
  return force / fit_line(radius.segment(begin, count), force.segment(begin, count)).slope;
}

ContactEvents contact_events(const Compliance& compliance, const Eigen::VectorXd& profile) {
  const Eigen::Index n = compliance.areas.size();
  const Eigen::MatrixXd factor = cholesky_factor(compliance);
  const auto& areas = compliance.areas;
  const Eigen::VectorXd by_indentation = factor.triangularView<Eigen::Lower>().solve(areas);
  const Eigen::VectorXd by_profile = factor.triangularView<Eigen::Lower>().solve(areas.cwiseProduct(profile));
  const Eigen::VectorXd effective = effective_radii(compliance);
  ContactEvents events{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index m = 0; m < n; ++m) {
    const auto row = factor.row(m).head(m);
    events.closing_rate[m] = 1 - row.dot(by_indentation.head(m)) / areas[m];
    events.indentation[m] = (profile[m] - row.dot(by_profile.head(m)) / areas[m]) / events.closing_rate[m];
    events.radius[m] = m == 0 ? 0 : (effective[m] + effective[m + 1]) / 2;
  }
  return events;
}

EdgeRadius largest_contact_radius(const NormalHistory& history, const ContactEvents& events) {
  Eigen::Index m = 0;
  while (m < history.smallest_gap.size() && history.smallest_gap[m] <= 0) ++m;
  if (m < 2 || m >= history.smallest_gap.size()) throw SolverError("the contact has no edge inside the contact line");
  const double deepest = events.indentation[m] - history.smallest_gap[m] / events.closing_rate[m];
  const double slope = (events.radius[m] - events.radius[m - 1]) / (events.indentation[m] - events.indentation[m - 1]);
  return {events.radius[m] + slope * (deepest - events.indentation[m]), events.radius[m] - events.radius[m - 1]};
}

EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& margin, Eigen::Index n_stuck) {
  if (n_stuck == 0) return {0, compliance.radii[1]};
  const double width = compliance.radii[n_stuck] - compliance.radii[n_stuck - 1];
  if (n_stuck < 4) return {effective_radii(compliance)[n_stuck], width};
  const Eigen::Index skipped = n_stuck < 8 ? 1 : n_skipped;
  const Eigen::Index n_points = std::min<Eigen::Index>(n_stuck - skipped, std::max<Eigen::Index>(8, n_stuck / 3));
  Eigen::VectorXd x(n_points), y(n_points);
  for (Eigen::Index k = 0; k < n_points; ++k) {
    const Eigen::Index i = n_stuck - skipped - n_points + k;
    x[k] = (compliance.radii[i] * compliance.radii[i] + compliance.radii[i + 1] * compliance.radii[i + 1]) / 2;
    y[k] = margin[i] * margin[i];
  }
  const double linear = std::sqrt(std::max(0.0, extrapolated_root(x, y, 1)));
  if (n_points < 5) return {linear, width};
  const double quadratic = std::sqrt(std::max(0.0, extrapolated_root(x, y, 2)));
  return {quadratic, std::abs(quadratic - linear)};
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
