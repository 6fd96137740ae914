#pragma once

#include <optional>

#include "comparison/support/log_slope.h"
#include "comparison/verification/trade/trade_levels.h"

namespace fretval {

/// Indices of the condensed levels for which no other one has both a smaller error and fewer seconds, by rising seconds
/// and falling error. Among levels with the same error the fastest counts, among equally fast ones the most accurate,
/// among equal ones the first; errors within 1e-6 of each other count as the same. Failed levels never count.
std::vector<std::size_t> front_of(const std::vector<TradeLevel>& levels);

/// Index of the fastest condensed level that meets a tolerance; empty: none does.
std::optional<std::size_t> cheapest(const std::vector<TradeLevel>& levels, double tolerance);

/// Whether errors are within a tolerance: T on the stick radii (and on the evidence of a limiting profile), T/10 on
/// contact radius and normal force, as in a verdict.
bool meets(const Quantities& errors, double tolerance);

/// Slope of the errors of an axis over its values, both coarsest first. It is taken over the errors before the first
/// one within three times the smallest: the errors of other settings are in all of them, and say nothing about the
/// order.
std::optional<LogSlope> observed_rate(std::vector<double> values, std::vector<double> errors);

/// The whole of trade.json, see docs/results.md. SI units; absent values are null.
nlohmann::ordered_json trade_json(const PreparedCase& prepared, const TradePlan& plan,
                                  const std::vector<TradeLevel>& levels);

}  // namespace fretval
