#include "comparison/simulation/fem_case/near_cycle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "fem/motion/motion.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

/// One direction of the motion, as depths of an element.
class Demand {
 public:
  Demand(const Stiffening& stiffening, double per_depth) : stiffening_(stiffening), per_depth_(per_depth) {}

  /// Of the harmonic with this order in a cycle of this frequency in Hz.
  void add(const mdr::Harmonic& harmonic, int order, double cycle) {
    if (harmonic.amplitude == 0) return;
    const double depth = harmonic.amplitude / per_depth_, rounded = depth * stiffening_(order * cycle);
    curvature_ += rounded * order * order;
    rounding_ += std::abs(rounded - depth * stiffening_(harmonic.frequency));
    repeats_ = std::gcd(repeats_, order);
  }

  [[nodiscard]] double curvature() const { return curvature_; }
  [[nodiscard]] double rounding() const { return rounding_; }
  /// How often it repeats in a cycle.
  [[nodiscard]] int repeats() const { return std::max(repeats_, 1); }

 private:
  const Stiffening& stiffening_;
  double per_depth_;
  double curvature_ = 0, rounding_ = 0;
  int repeats_ = 0;
};

/// Orders of the harmonics in a cycle of q cycles of the normal motion. Tangential ones that are multiples of one
/// frequency stay so.
mdr::CommonCycle cycle_of(const mdr::HarmonicMotion& motion, const mdr::CommonCycle& of_normal, int q) {
  mdr::CommonCycle cycle{of_normal.frequency / q, of_normal.normal_orders, {}};
  for (int& order : cycle.normal_orders) order *= q;
  const auto order = [&cycle](double frequency) {
    return static_cast<int>(std::max(std::round(frequency / cycle.frequency), 1.0));
  };
  if (const auto tangential = mdr::common_cycle({motion.indentation, {}, motion.tangential})) {
    cycle.tangential_orders = tangential->tangential_orders;
    for (int& own : cycle.tangential_orders) own *= order(tangential->frequency);
  } else {
    for (const auto& [amplitude, frequency, phase] : motion.tangential)
      cycle.tangential_orders.push_back(amplitude == 0 ? 0 : order(frequency));
  }
  return cycle;
}

}  // namespace

NearCycle near_cycle(const mdr::HarmonicMotion& motion, const Stiffening& stiffening, double friction_coefficient,
                     int n_creep_cycles) {
  const int n_oscillations = 2 * n_creep_cycles, slow_enough_to_creep = n_oscillations / 12;
  const auto of_normal = mdr::common_cycle({motion.indentation, motion.normal, {}}).value();
  std::optional<NearCycle> nearest;
  for (int q = 1;; ++q) {
    const auto cycle = cycle_of(motion, of_normal, q);
    if (nearest && cycle.highest_order() > n_oscillations) return *nearest;
    Demand normal(stiffening, 1), tangential(stiffening, 1.5 * friction_coefficient);
    for (std::size_t j = 0; j < motion.normal.size(); ++j)
      normal.add(motion.normal[j], cycle.normal_orders[j], cycle.frequency);
    for (std::size_t k = 0; k < motion.tangential.size(); ++k)
      tangential.add(motion.tangential[k], cycle.tangential_orders[k], cycle.frequency);
    const double a = normal.curvature(), b = tangential.curvature();
    double lag = fem::pi / std::lcm(normal.repeats(), tangential.repeats());
    const bool creeps = cycle.highest_order() <= slow_enough_to_creep;
    if (creeps) lag *= fem::pi / fem::creep_period(n_creep_cycles, cycle.highest_order());
    const double error = tangential.rounding() + (a + b > 0 ? a * b / (a + b) * lag * lag / 2 : 0);
    if (!nearest || error < nearest->error_of_demand) nearest = NearCycle{cycle, creeps, error};
  }
}

}  // namespace fretval
