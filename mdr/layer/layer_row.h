#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "mdr/layer/layer_kernel.h"
#include "mdr/profiles/profile.h"
#include "mdr/support/gauss_legendre.h"

namespace fretval::mdr {

/// The row of coupled springs of one contact radius, by Nystrom's method: the equation of mdr/layer/layer_kernel.h held
/// at the points of a Gauss rule on 0 < x < a, which takes its integral. Between the points q is what the equation says
/// it is, q = E* w - coupling: as the coupling is smooth, so is the error, and what is not smooth in w stays exact.
/// Spectral in the number of points where w is smooth between the breaks of the rule.
class LayerRow {
 public:
  LayerRow(LayerKernel kernel, QuadratureRule rule);

  /// q/E* at the points, in m, for depths w at the points, in m.
  [[nodiscard]] Eigen::ArrayXd load(const Eigen::ArrayXd& depth) const;
  /// Amplitudes of a load at the points.
  [[nodiscard]] Eigen::ArrayXd amplitudes_of(const Eigen::ArrayXd& load) const;
  /// int_0^a q/E* dx of a load at the points, in m^2.
  [[nodiscard]] double integral(const Eigen::ArrayXd& load) const { return (rule_.weight * load).sum(); }

  [[nodiscard]] const Eigen::ArrayXd& points() const { return rule_.point; }
  [[nodiscard]] const LayerKernel& kernel() const { return kernel_; }

 private:
  LayerKernel kernel_;
  QuadratureRule rule_;
  Eigen::PartialPivLU<Eigen::MatrixXd> matrix_;
};

/// How finely: of panels as long as suits the layer and the profile.
struct RowFineness {
  int points_of_panel = 16;
};

/// Panels on a length in m, none longer than 2 H: what reaches the surface of a layer is smooth on that length.
int panels_on(const Layer& layer, double length);

/// Breaks of panels on 0 <= x <= end: those of panels_on(), cut at the kinks of the profile's image, and graded towards
/// those and towards a tip that is no power of x.
std::vector<double> row_breaks(const Profile& profile, const Layer& layer, double end);

/// The row up to `end`, with a kernel that reaches as far as `outer` >= end on either side.
LayerRow layer_row(const Profile& profile, const Layer& layer, Direction direction, double end, double outer,
                   const RowFineness& fineness = {});

}  // namespace fretval::mdr
