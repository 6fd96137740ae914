#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/support/log_slope.h"
#include "comparison/verification/trade/trade_levels.h"
#include "comparison/verification/trade/trade_plan.h"

namespace fretval {

/// One setting of the condensed finite elements, computed alone with a body of its own.
struct TradePoint {
  Resolution resolution;
  std::set<std::string> sweeps;  ///< see TradePlan::settings
  Quantities errors = {};        ///< against the closed form; empty: it failed
  double seconds = 0;            ///< of the body and the histories
  long n_normal_steps = 0, n_friction_steps = 0;
  std::optional<double> memory_bytes = {};  ///< measured peak growth of the process, see ResidentGrowth
  nlohmann::ordered_json cost = {};         ///< see cost_json
  std::string failure = {};

  [[nodiscard]] double error() const { return largest_of(errors); }
};

/// Observed rate over one axis: error ~ value^slope, over the errors above the floor (see observed_rate). Empty: fewer
/// than two of them.
struct AxisRate {
  const char* axis;
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
  ClosedForm closed_form;
  std::vector<SpringLevel> springs = {};  ///< of an unworn indenter under a locked phase
  std::vector<TradePoint> points = {};
  std::vector<FullLevel> full = {};
  std::vector<std::size_t> front = {};  ///< indices of points, by rising seconds
  std::vector<AxisRate> rates = {};
  std::vector<Recommendation> recommendations = {};
};

/// Points of an axis, coarsest first; failed ones are left out.
std::vector<std::size_t> members_of(const std::vector<TradePoint>& points, const TradeAxis& axis);

/// Computes a plan. Failures of the numerics at a setting are part of the answer. Needs a PetscSession. Throws
/// std::runtime_error where the closed form fails.
Trade compute_trade(const PreparedCase& prepared, const TradePlan& plan);

/// The whole of trade.json: every point with its settings, errors, seconds and memory; the front, the rates and the
/// recommended settings refer to `points` by index. SI units; absent values are null.
nlohmann::ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan, const Trade& trade);

}  // namespace fretval
