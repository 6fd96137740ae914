#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/verification/trade/trade_front.h"
#include "comparison/verification/trade/trade_levels.h"
#include "comparison/verification/trade/trade_plan.h"

namespace fretval {

/// Seconds of one setting, computed alone with a body of its own. Each stage is the fastest of TradePlan::n_repetitions
/// runs: what slows a run down is not its own.
struct TradeSeconds {
  BodyCost body;
  double normal_history = 0, friction_history = 0;
  [[nodiscard]] double total() const;
};

/// One setting of the condensed finite elements.
struct TradePoint {
  PlannedSetting setting;
  Quantities errors;  ///< against the closed form; empty: it failed
  TradeSeconds seconds;
  std::optional<double> memory_bytes;  ///< measured peak growth of the process, see ResidentGrowth
  unsigned n_dofs = 0;
  std::size_t n_contact_nodes = 0;
  Eigen::Index n_rings = 0;
  long n_normal_steps = 0, n_friction_steps = 0;
  int n_cycles = 0;
  std::string failure;

  [[nodiscard]] double error() const { return largest_of(errors); }
};

/// Full finite elements: their error is that of the condensed ones at the same resolution, which they equal.
struct FullLevel {
  FullPoint point;
  std::size_t condensed;  ///< index of the same setting in Trade::points
  double extrapolated_seconds;
};

/// Observed rate of a one-axis sweep: error ~ value^slope, over the errors above the floor (see observed_rate). Empty:
/// fewer than two of them.
struct AxisRate {
  Sweep sweep;
  std::map<Quantity, std::optional<LogSlope>> slope;  ///< by quantity
  std::optional<LogSlope> largest_error;              ///< slope of the largest error
};

/// The recommended setting for a tolerance and the tool's own choice.
struct Recommendation {
  double tolerance;
  std::optional<std::size_t> cheapest;  ///< index of a point; empty: no setting of the plan is good enough
  std::size_t chosen;
  bool chosen_meets;
};

/// What a trade comes to.
struct Trade {
  ClosedForm reference;
  std::vector<SpringPoint> springs;
  std::vector<TradePoint> points;
  std::vector<FullLevel> full;
  std::vector<std::size_t> front;  ///< indices of points, by rising seconds
  std::vector<AxisRate> rates;
  std::optional<LogSlope> seconds_over_rings;  ///< exponent, from the sweep over the rings
  std::vector<Recommendation> recommendations;
};

/// Value of the axis that a one-axis sweep varies.
double axis_value(Sweep sweep, const Resolution& resolution);

/// Points of a sweep by rising value of its axis; failed ones are left out.
std::vector<std::size_t> members_of(const std::vector<TradePoint>& points, Sweep sweep);

constexpr std::array<Sweep, 4> rated_sweeps{Sweep::rings, Sweep::time_step, Sweep::far_field, Sweep::grading};

/// Rate of a sweep, from its points.
AxisRate rate_of(const std::vector<TradePoint>& points, Sweep sweep);

/// Computes a plan. Failures of the numerics at a setting are part of the answer. Needs a PetscSession. Throws
/// std::runtime_error where the closed form fails.
Trade compute_trade(const PreparedCase& prepared, const TradePlan& plan);

}  // namespace fretval
