#include "fem/ring_contact/stick_zone/stick_radius.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fem/ring_contact/stencil.h"

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

}  // namespace

EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& reserve, Eigen::Index n_stuck) {
  return stick_radius(compliance, n_stuck > 0 ? effective_radii(compliance) : EffectiveRadii{}, reserve, n_stuck);
}

EdgeRadius stick_radius(const Compliance& compliance, const EffectiveRadii& edges, const Eigen::VectorXd& reserve,
                        Eigen::Index n_stuck) {
  if (n_stuck == 0) return {0, compliance.radii[1]};
  const auto& [effective, of_rings, scatter, calibration] = edges;
  const double width = compliance.radii[n_stuck] - compliance.radii[n_stuck - 1];
  if (n_stuck < 3) return {effective[n_stuck], width};
  const Eigen::Index n = std::min(n_stuck, n_fitted_events);
  Eigen::VectorXd radius(n), load(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index j = n_stuck - n + k;
    radius[k] = of_rings[j];
    load[k] = reserve[j];
  }
  // The next ring has slipped. Next to a sharp edge of the indenter the reserve falls too steeply for the fit to see
  // it.
  const double next = n_stuck < of_rings.size() ? of_rings[n_stuck] : effective[n_stuck];
  const double limit = next + width / 4;
  const auto root = [&](Eigen::Index n_events, Eigen::Index degree) {
    const Eigen::Index m = std::min(n, n_events);
    return root_beyond(radius.tail(m), load.tail(m), static_cast<int>(std::min(m - 1, degree)), limit);
  };
  // The cubic through six. Through three there is nothing but the parabola and the line, nor where the reserve has a
  // kink further inside, as at the edge of a flat.
  const auto fitted = root(4, 2), cubic = n > 3 ? root(n_fitted_events, 3) : std::nullopt,
             other = cubic ? cubic : root(2, 1);
  if (!fitted || !other) return {(radius[n - 1] + next) / 2, width};
  const double relative_width = width / compliance.radii.back();
  // Over a half-space the reserve of a parabola is a parabola; the base of a layer bends it.
  const auto bent = compliance.half_space && n > 3 ? root(4, 3) : std::nullopt;
  const double read = bent.value_or(*fitted);
  return {read, 2 * std::abs(*fitted - *other) + scatter + calibration + relative_width * relative_width * width};
}

}  // namespace fretval::fem
