#include "mdr/springs/spring_stick.h"

namespace fretval::mdr {

double stick_depth(const SpringBed& bed, double mu, const Eigen::ArrayXd& margin, const SlipOfSprings& slip) {
  Eigen::Index n = 0;
  while (n < margin.size() && slip.path[n] <= slip.allowed && margin[n] > 0) ++n;
  if (n == 0) return bed.depth[0] - slip.path[0] / slip.n_ways / (1.5 * mu);
  return bed.depth[n - 1] + margin[n - 1] / (1.5 * mu);
}

}  // namespace fretval::mdr
