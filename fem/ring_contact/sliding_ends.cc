#include "fem/ring_contact/sliding_ends.h"

#include <algorithm>
#include <cmath>

namespace fretval::fem {
namespace {

/// One punch in the steps of a period, which may repeat.
class PunchOfPeriod {
 public:
  PunchOfPeriod(const Eigen::MatrixXd& depths, const Eigen::MatrixXd& limit_depths, Eigen::Index i, double close)
      : depths_(depths), limits_(limit_depths), i_(i), close_(close) {}

  [[nodiscard]] double room(double way, Eigen::Index k) const { return limit(k) - way * depth(k); }
  [[nodiscard]] bool presses(Eigen::Index k) const { return limit(k) > close_; }
  [[nodiscard]] bool sticks(Eigen::Index k) const { return presses(k) && std::abs(depth(k)) < limit(k) - close_; }
  [[nodiscard]] bool slides(double way, Eigen::Index k) const { return presses(k) && room(way, k) <= close_; }

  /// What the samples k, k + 1 and k + 2 lock in, if one of the steps between them is the last one that slides.
  [[nodiscard]] double locked_in(double way, Eigen::Index k) const {
    if (!presses(k) || !sticks(k + 1) || !sticks(k + 2)) return 0;
    const double now = room(way, k), next = room(way, k + 1), after = room(way, k + 2);
    const double bend = after - 2 * next + now, slope = (after - now) / 2;  // at k + 1
    const double vertex = -slope / bend;                                    // steps from k + 1
    const bool ends = slides(way, k) ? next > close_ : now > next && next <= after;
    if (!ends || bend <= 0) return 0;
    constexpr double half = 0.5;
    const double x = slides(way, k) ? std::clamp(vertex + 1, -half, half) : vertex;
    return slides(way, k) ? bend * x * x / 2 : std::max(0.0, bend * x * x / 2 - next);
  }

 private:
  [[nodiscard]] double depth(Eigen::Index k) const { return depths_(i_, k % depths_.cols()); }
  [[nodiscard]] double limit(Eigen::Index k) const { return limits_(i_, k % limits_.cols()); }

  const Eigen::MatrixXd &depths_, &limits_;
  Eigen::Index i_;
  double close_;
};

}  // namespace

Eigen::VectorXd force_off_by_sliding_ends(const PunchSeries& series, const Eigen::MatrixXd& depths,
                                          const Eigen::MatrixXd& limit_depths, bool repeats) {
  constexpr double roundoff = 1e-9;
  const Eigen::Index n = depths.cols(), n_that_may_end = repeats ? n : n - 2;
  Eigen::VectorXd off = Eigen::VectorXd::Zero(n);
  if (n == 0) return off;
  const double close = roundoff * limit_depths.maxCoeff();
  for (Eigen::Index i = 0; i < depths.rows(); ++i) {
    const PunchOfPeriod punch(depths, limit_depths, i, close);
    const double force = series.punch_force(i + 1) - series.punch_force(i);
    for (const double way : {1.0, -1.0})
      for (Eigen::Index k = 0; k < n_that_may_end; ++k) {
        const double depth = punch.locked_in(way, k);
        const Eigen::Index end = repeats ? k + n : n;
        for (Eigen::Index j = k + 1; depth > 0 && j < end && punch.sticks(j); ++j) off[j % n] += way * force * depth;
      }
  }
  return off;
}

}  // namespace fretval::fem
