#include "mdr/layer/layer_row.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// Images that are no polynomial at a kink or tip: panels from there on grow by 4, so that the first one, in which alone
// the rule is not spectral, is 1e-7 of the whole.
constexpr int n_graded = 12;
constexpr double growth = 4;

bool is_smooth_at_tip(const Profile& profile) {
  const auto* power = std::get_if<PowerLaw>(&profile);
  return power == nullptr || power->exponent == std::round(power->exponent);
}

void add_graded(std::vector<double>& breaks, double from, double to) {
  double part = std::pow(growth, -n_graded);
  for (int i = 0; i < n_graded; ++i, part *= growth) breaks.push_back(from + part * (to - from));
}

}  // namespace

LayerRow::LayerRow(LayerKernel kernel, QuadratureRule rule)
    : kernel_(std::move(kernel)),
      rule_(std::move(rule)),
      matrix_(coupling_matrix(kernel_, rule_.point, rule_.weight) +
              Eigen::MatrixXd::Identity(rule_.point.size(), rule_.point.size())) {}

Eigen::ArrayXd LayerRow::load(const Eigen::ArrayXd& depth) const {
  return matrix_.solve(depth.matrix()).array();
}

Eigen::ArrayXd LayerRow::amplitudes_of(const Eigen::ArrayXd& load) const {
  return amplitudes(kernel_, rule_.point, rule_.weight * load);
}

int panels_on(const Layer& layer, double length) {
  return std::max(1, static_cast<int>(std::ceil(length / (2 * layer.thickness))));
}

std::vector<double> row_breaks(const Profile& profile, const Layer& layer, double end) {
  validate(layer);
  require_positive("end of the row", end);
  std::vector<double> corners{0}, breaks;
  for (const double kink : transform_kinks(profile))
    if (kink > 0 && kink < end) corners.push_back(kink);
  corners.push_back(end);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = corners[i], to = corners[i + 1];
    const int n = panels_on(layer, to - from);
    const double first = from + (to - from) / n;
    breaks.push_back(from);
    if (i > 0 || !is_smooth_at_tip(profile)) add_graded(breaks, from, first);
    for (int k = 1; k < n; ++k) breaks.push_back(from + (to - from) * k / n);
  }
  breaks.push_back(end);
  return breaks;
}

LayerRow layer_row(const Profile& profile, const Layer& layer, Direction direction, double end, double outer,
                   const RowFineness& fineness) {
  return {layer_kernel(layer, direction, 2 * std::max(end, outer)),
          gauss_legendre(row_breaks(profile, layer, end), fineness.points_of_panel)};
}

}  // namespace fretval::mdr
