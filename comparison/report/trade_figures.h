#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "comparison/report/figures.h"

namespace fretval {

/// Figures of a trade.json: error over seconds and over memory with the front, and error over each axis that was swept
/// alone. Both axes logarithmic.
std::vector<Figure> trade_figures(const nlohmann::ordered_json& trade);

}  // namespace fretval
