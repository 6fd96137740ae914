#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/verification/trade/trade.h"

namespace fretval {

/// The whole of trade.json: every point with its settings, errors, seconds and memory; the front, the rates and the
/// recommended settings refer to `points` by index. SI units; absent values are null.
nlohmann::ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan, const Trade& trade);

}  // namespace fretval
