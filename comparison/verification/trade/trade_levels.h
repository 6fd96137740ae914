#pragma once

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/verification/trade/trade_plan.h"

namespace fretval {

/// A way to answer a case at one setting, computed alone.
struct TradeLevel {
  std::string kind;  ///< "condensed", "all dofs", "springs", "closed form"
  nlohmann::ordered_json setting;
  std::map<std::string, double> axes = {};  ///< for condensed: its values on axes, see TradePlan
  Quantities errors = {};                   ///< against the closed form; empty: it failed
  double seconds = std::nan("");            ///< finite elements: of a body of its own, and of the histories
  std::string failure = {};

  [[nodiscard]] double error() const { return largest_of(errors); }
};

/// Every level of a plan: first the condensed ones in the order of plan.settings, then the others:
///
///   all dofs: the finite elements with every degree of freedom as an unknown. They equal the condensed ones
///   (fem/full_model/full_history.h), whose errors they have; their seconds are extrapolated from two cycles;
///   springs: the spring foundation stepped through the motion, which has no contact radius; not for a worn indenter or
///   an unlocked phase;
///   closed form: the fastest of half a second.
///
/// A failure of the numerics at a setting is kept as the failure of its level. Needs a PetscSession. Throws
/// std::runtime_error where the closed form fails.
std::vector<TradeLevel> computed_levels(const PreparedCase& prepared, const TradePlan& plan);

}  // namespace fretval
