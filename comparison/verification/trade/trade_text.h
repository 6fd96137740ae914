#pragma once

#include <string>

#include "comparison/verification/trade/trade.h"

namespace fretval {

/// The front, the recommended settings beside the tool's own, the other levels and the rates, as text for a terminal.
std::string trade_text(const Trade& trade);

}  // namespace fretval
