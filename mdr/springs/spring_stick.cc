#include "mdr/springs/spring_stick.h"

#include <algorithm>

namespace fretval::mdr {

double stick_depth(const SpringBed& bed, double mu, const Eigen::ArrayXd& margin, const Eigen::ArrayXd& slip_path,
                   double allowed) {
  Eigen::Index n = 0;
  while (n < margin.size() && slip_path[n] <= allowed && margin[n] > 0) ++n;
  if (n == 0) return bed.depth[0] + std::min(0.0, margin[0] / (1.5 * mu));
  return bed.depth[n - 1] + margin[n - 1] / (1.5 * mu);
}

}  // namespace fretval::mdr
