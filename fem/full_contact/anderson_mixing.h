#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace fretval::fem {

/// Speeds up the iteration of a map towards its fixed point x = g(x). Each next x is the image of that combination of
/// the last ones for which the residual g(x) - x would be least if g were affine: with differences from one iterate to
/// the next,
///
///   x_next = g - (dX + dR) gamma,    gamma = argmin |r - dR gamma|,   r = g - x.
///
/// (Anderson 1965, type II; Walker and Ni, SIAM J. Numer. Anal. 49, 2011.) It has the fixed point of the plain
/// iteration, and where that contracts fast it takes about as many applications of g.
class AndersonMixing {
 public:
  /// depth: how many differences are kept; 0: the plain iteration.
  explicit AndersonMixing(std::size_t depth) : depth_(depth) {}

  /// The iterate after x, whose image is g(x), of the same size as x.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

 private:
  std::size_t depth_;
  Eigen::VectorXd x_, residual_;                               // of the iterate before; empty: there is none
  std::vector<Eigen::VectorXd> x_changes_, residual_changes_;  // the oldest one first
};

}  // namespace fretval::fem
