#include "comparison/simulation/near_cycle.h"

#include <cmath>
#include <numeric>
#include <optional>

#include "fem/support/constants.h"

namespace fretval {
namespace {

/// One direction of the motion, in units of depth of an element.
class Demand {
 public:
  Demand(const FemCase& fem, double per_depth) : fem_(fem), per_depth_(per_depth) {}

  /// Of the harmonic with this order in a cycle of this frequency in Hz.
  void add(const mdr::Harmonic& harmonic, int order, double cycle) {
    if (harmonic.amplitude == 0) return;
    const double rounded = amplitude_at(harmonic, order * cycle);
    curvature_ += rounded * order * order;
    rounding_ += std::abs(rounded - amplitude_at(harmonic, harmonic.frequency));
    multiple_ = std::lcm(multiple_, long{order});
  }

  [[nodiscard]] double curvature() const { return curvature_; }
  [[nodiscard]] double rounding() const { return rounding_; }
  [[nodiscard]] long multiple() const { return multiple_; }

 private:
  [[nodiscard]] double amplitude_at(const mdr::Harmonic& harmonic, double frequency) const {
    const double omega = mdr::angular_frequency(frequency) / fem_.units.angular_frequency;
    return harmonic.amplitude / fem_.units.depth / per_depth_ * fem::stiffening_at(fem_.relaxation, omega);
  }

  const FemCase& fem_;
  double per_depth_;
  double curvature_ = 0, rounding_ = 0;
  long multiple_ = 1;
};

/// The cycle of q cycles of the normal motion.
NearCycle cycle_of(const FemCase& fem, const mdr::CommonCycle& of_normal, int q, int n_oscillations) {
  constexpr int enough_to_creep = 12;
  const auto& motion = *fem.without_short_cycle;
  NearCycle near{{of_normal.frequency / q, of_normal.normal_orders, {}}, false, 0};
  Demand normal(fem, 1), tangential(fem, 1.5 * fem.friction_coefficient);
  for (std::size_t j = 0; j < motion.normal.size(); ++j)
    normal.add(motion.normal[j], near.cycle.normal_orders[j] *= q, near.cycle.frequency);
  for (const auto& harmonic : motion.tangential) {
    const auto order = static_cast<int>(std::max(std::round(harmonic.frequency / near.cycle.frequency), 1.0));
    near.cycle.tangential_orders.push_back(harmonic.amplitude == 0 ? 0 : order);
    tangential.add(harmonic, order, near.cycle.frequency);
  }
  const double a = normal.curvature(), b = tangential.curvature();
  double lag = fem::pi / static_cast<double>(std::lcm(normal.multiple(), tangential.multiple()));
  const int n_cycles = n_oscillations / near.cycle.highest_order();
  near.creeps = n_cycles >= enough_to_creep;
  if (near.creeps) lag *= fem::pi / n_cycles;
  near.error_of_demand = tangential.rounding() + (a + b > 0 ? a * b / (a + b) * lag * lag / 2 : 0);
  return near;
}

}  // namespace

NearCycle near_cycle(const FemCase& fem, int n_oscillations) {
  const auto& motion = *fem.without_short_cycle;
  const auto of_normal = mdr::common_cycle({motion.indentation, motion.normal, {}}).value();
  std::optional<NearCycle> nearest;
  for (int q = 1;; ++q) {
    auto next = cycle_of(fem, of_normal, q, n_oscillations);
    if (nearest && next.cycle.highest_order() > n_oscillations) return *nearest;
    if (!nearest || next.error_of_demand < nearest->error_of_demand) nearest = std::move(next);
  }
}

}  // namespace fretval
