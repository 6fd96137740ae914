#include "fem/ring_contact/growing_edge.h"

#include <array>
#include <cmath>

#include "fem/ring_contact/stencil.h"
#include "fem/support/constants.h"
#include "fem/support/mean_decay.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

constexpr std::size_t n_moments = 6;

/// `int_0^1 exp(-z s) s^k ds`, k = 0 to 5.
std::array<double, n_moments> decaying_moments(double z) {
  std::array<double, n_moments> moments{};
  const double at_end = std::exp(-z);
  if (z > 5) {  // upwards
    moments[0] = (1 - at_end) / z;
    for (std::size_t k = 1; k < n_moments; ++k) moments[k] = (static_cast<double>(k) * moments[k - 1] - at_end) / z;
    return moments;
  }
  // The last one by a series of positive terms, the others downwards: nothing cancels.
  double term = 1.0 / n_moments, sum = term;
  for (int j = 1; term > 1e-17 * sum; ++j) sum += term *= z / (n_moments + j);
  moments.back() = at_end * sum;
  for (std::size_t k = n_moments - 1; k-- > 0;) moments[k] = (at_end + z * moments[k + 1]) / static_cast<double>(k + 1);
  return moments;
}

/// `int_0^z (1 - exp(-s)) ds / z^2`: 1/2 at z = 0, where the difference of decays would cancel.
double mean_rise(double z) {
  return z > 1e-3 ? (1 - mean_decay(z)) / z : 0.5 - z / 6;
}

/// Way of the edge since a time ago, `R(t) = c_1 t + c_2 t^2 + c_3 t^3`, in units of the longest time.
class WayOfEdge {
 public:
  /// Through three times, which rise, and the ways since then.
  WayOfEdge(const Eigen::Vector3d& times, const Eigen::Vector3d& ways) : unit_(times[2]) {
    Eigen::Matrix3d powers;
    for (Index i = 0; i < 3; ++i) {
      const double t = times[i] / unit_;
      powers.row(i) << t, t * t, t * t * t;
    }
    c_ = powers.partialPivLu().solve(ways);
  }
  /// Whether the edge went outwards all the time.
  [[nodiscard]] bool always_grows() const {
    const double at_extremum = c_[2] != 0 ? -c_[1] / (3 * c_[2]) : -1;
    return c_[0] >= 0 && rate(1) >= 0 && (at_extremum <= 0 || at_extremum >= 1 || rate(at_extremum) >= 0);
  }
  [[nodiscard]] double rate_now() const { return c_[0] / unit_; }
  /// `int_0^t exp(-y/tau) R'(y) dy`.
  [[nodiscard]] double decayed(double t, double tau) const {
    const double end = t / unit_;
    const auto m = decaying_moments(t / tau);
    return end * (c_[0] * m[0] + end * (2 * c_[1] * m[1] + end * 3 * c_[2] * m[2]));
  }
  /// `int_0^t exp(-y/tau) R'(y) R(y) dy` over all of the time.
  [[nodiscard]] double decayed_moment(double tau) const {
    const auto m = decaying_moments(unit_ / tau);
    const double a = c_[0], b = c_[1], c = c_[2];
    return a * a * m[1] + 3 * a * b * m[2] + (4 * a * c + 2 * b * b) * m[3] + 5 * b * c * m[4] + 3 * c * c * m[5];
  }

 private:
  [[nodiscard]] double rate(double t) const { return c_[0] + t * (2 * c_[1] + 3 * c_[2] * t); }
  double unit_;
  Eigen::Vector3d c_;
};

/// Nothing is known of how the depths fall to the edge: they may go on to it as their cubic, or fall to zero from the
/// last ring on. The uncertainty is half of what lies between.
ForceAtEdge unknown_fall(const PunchSeries& series, const Eigen::VectorXd& depths, Index last, double edge) {
  const auto& places = series.places();
  const double at_edge = Stencil{places, depths, last + 1 - n_stencil, n_stencil}(edge);
  return {0, std::abs(series.force_per_radius() * at_edge * (edge - places[last]) / 2) / 2};
}

}  // namespace

ForceAtEdge force_missed_at_edge(const PunchSeries& series, const Eigen::VectorXd& depths, Index n_pressed,
                                 double radius, const TimesInContact& times) {
  const auto& [relaxation, in_contact] = times;
  if (relaxation.moduli.empty()) return {};
  const Index last = n_pressed - 1;
  const double edge = series.place_of(radius);
  // From the last ring inwards.
  Eigen::Vector4d t, way;
  for (Index i = 0; i < 4; ++i) {
    t[i] = in_contact[last - i];
    way[i] = edge - series.places()[last - i];
  }
  if (!(way[0] > 0)) return {};
  const bool one_after_the_other = 0 < t[0] && t[0] < t[1] && t[1] < t[2] && t[2] < infinity && t[2] <= t[3];
  if (!one_after_the_other) return unknown_fall(series, depths, last, edge);
  const WayOfEdge path(t.head<3>(), way.head<3>());
  if (!path.always_grows()) return unknown_fall(series, depths, last, edge);
  // PunchSeries::integral takes the cubic through these four rings from halfway between the inner two of them on.
  const double half_way = (way[3] - way[2]) / 2, half_time = (t[3] - t[2]) / 2;
  Eigen::Vector3d law = relaxation.relaxed * way.head<3>();
  law.array() += relaxation.viscosity * path.rate_now();
  double missed = 0;
  for (std::size_t i = 0; i < relaxation.moduli.size(); ++i) {
    const double g = relaxation.moduli[i], tau = relaxation.times[i];
    Eigen::Vector4d load;
    for (Index k = 0; k < 3; ++k) load[k] = path.decayed(t[k], tau);
    const double before = std::exp(-t[2] / tau), z = half_time / tau;
    load[3] = load[2] + 2 * half_way * before * mean_decay(2 * z);
    const double exact =
        load[2] * (way[2] + half_way) - path.decayed_moment(tau) + half_way * half_way * before * mean_rise(z);
    missed += g * (exact - Stencil{way, load, 0, n_stencil}.integral(0, way[2] + half_way));
    law += g * load.head<3>();
  }
  const Eigen::Vector3d slope = depths.segment<3>(last - 2).reverse().cwiseQuotient(law);
  const double at_edge = slope[1] + (slope[1] - slope[2]) * way[1] / (way[2] - way[1]),
               per_slope = series.force_per_radius() * missed;
  return {at_edge * per_slope, std::abs((at_edge - slope[0]) * per_slope)};
}

}  // namespace fretval::fem
