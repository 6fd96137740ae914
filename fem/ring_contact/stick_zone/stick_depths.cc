#include "fem/ring_contact/stick_zone/stick_depths.h"

#include <algorithm>

namespace fretval::fem {
namespace {

/// Where falling depths pass a level first; 0: nowhere are they above it.
double crossing(const StickDepths& depths, double level) {
  const auto& [depth, radius] = depths;
  Eigen::Index n = 0;
  while (n < depth.size() && depth[n] > level) ++n;
  if (n == 0) return 0;
  if (n == depth.size()) return 1;
  const double share = (depth[n - 1] - level) / (depth[n - 1] - depth[n]);
  return radius[n - 1] + share * (radius[n] - radius[n - 1]);
}

}  // namespace

StickDepths stick_depths(const StickRings& rings, const Eigen::VectorXd& radii, double tangential_per_depth,
                         double longest) {
  const Eigen::Index n = rings.reserve.size();
  StickDepths depths{Eigen::VectorXd(n), radii.head(n)};
  for (Eigen::Index j = 0; j < n; ++j)
    depths.depth[j] = (j < rings.n_stuck ? rings.reserve[j] : -std::min(rings.slip[j], longest)) / tangential_per_depth;
  return depths;
}

bool sticks_nowhere(const StickDepths& depths) {
  const auto& depth = depths.depth;
  return depth.size() > 1 && depth[0] + 2 * (depth[0] - depth[1]) < 0;
}

double reach_of_edge(const StickDepths& depths, double c, double uncertainty) {
  return std::max({c - crossing(depths, uncertainty), crossing(depths, -uncertainty) - c, 0.0});
}

double width_of_edge(const StickDepths& depths, double uncertainty) {
  const auto& [depth, radius] = depths;
  Eigen::Index n = 0;
  while (n < depth.size() && depth[n] > 0) ++n;
  const double slope = n < 2 ? 0 : (depth[n - 2] - depth[n - 1]) / (radius[n - 1] - radius[n - 2]);
  if (slope > 0) return 2 * uncertainty / slope;
  return crossing(depths, -uncertainty) - crossing(depths, uncertainty);
}

}  // namespace fretval::fem
