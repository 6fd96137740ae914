#include "mdr/springs/spring_bed.h"

#include <cmath>

#include "mdr/profiles/zone_depth.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

SpringBed equal_intervals(double outer_radius, Eigen::Index n_springs) {
  require_positive("outer radius of the springs", outer_radius);
  require_positive("number of springs", static_cast<double>(n_springs));
  const double width = outer_radius / static_cast<double>(n_springs);
  const Eigen::ArrayXd index = Eigen::ArrayXd::LinSpaced(n_springs, 0, static_cast<double>(n_springs - 1));
  return {(index + 0.5) * width, Eigen::ArrayXd::Constant(n_springs, width), Eigen::ArrayXd(n_springs)};
}

}  // namespace

SpringBed spring_bed(const Profile& profile, double outer_radius, Eigen::Index n_springs) {
  SpringBed bed = equal_intervals(outer_radius, n_springs);
  double below = 0;
  for (Eigen::Index j = 0; j < n_springs; ++j) {
    const double end = outer_radius * static_cast<double>(j + 1) / static_cast<double>(n_springs);
    const double above = transform_integral(profile, end);
    bed.depth[j] = (above - below) / bed.width[j];
    below = above;
  }
  bed.zone_depth = bed.depth;
  for (Eigen::Index j = 0; j < n_springs && bed.depth[j] == 0; ++j)
    bed.zone_depth[j] = zone_depth(profile, bed.position[j]);
  return bed;
}

SpringBed spring_bed(const std::function<double(double)>& g, double outer_radius, Eigen::Index n_springs) {
  SpringBed bed = equal_intervals(outer_radius, n_springs);
  bed.depth = bed.zone_depth = bed.position.unaryExpr(g);
  return bed;
}

Eigen::ArrayXd axis_weights(const SpringBed& bed) {
  const Eigen::Index n = bed.position.size();
  Eigen::ArrayXd between = (bed.position + bed.width / 2).inverse();
  between[0] *= 1.5;  // the first half spring has the slope of the springs next to it
  Eigen::ArrayXd weights = between;
  weights.tail(n - 1) -= between.head(n - 1);
  return weights / pi;
}

}  // namespace fretval::mdr
