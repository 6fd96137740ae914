#pragma once

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/simulation/fem_case/fem_case.h"
#include "comparison/support/statistics.h"

namespace fretval {

/// The values that a trade takes for the entries of a resolution, coarsest first.
struct TradeGrid {
  std::vector<unsigned> rings{8, 12, 16, 24, 32, 48, 64, 96, 128}, orders{2, 3, 4}, joint_orders{2, 3};
  std::vector<double> gradings{0.6, 0.3, 0.15}, far_radii{3, 6, 12, 25};
  std::vector<int> steps{12, 24, 48, 96, 192};
  std::vector<unsigned> full_rings{8, 16};
  std::vector<double> tolerances{1e-2, 1e-3, 1e-4};
};

/// What a trade computes.
struct TradePlan {
  Resolution reference;  ///< on all axes
  /// Settings of the condensed finite elements. A setting that differs from the reference on one axis alone is stored
  /// with its value on that axis, by the name of the axis; the other settings combine rings, order and time steps, or
  /// are the tool's own choice.
  std::map<Resolution, std::map<std::string, double>> settings;
  std::vector<Resolution> full;    ///< stepped with every degree of freedom
  std::vector<double> tolerances;  ///< for which settings are recommended, falling
};

/// The resolution that `resolution_for` chooses for a case.
Resolution chosen_resolution(double tolerance, const FemCase& fem);

/// Start, creep and periodicity of the combined settings go with their time steps as in `resolution_for`, and their far
/// radius with their rings: 12 up to 32 rings, 25 beyond. Their grading is 0.3; the rings at a worn edge are those for
/// 1e-3 throughout. An unlocked phase makes histories long: then at most 48 rings and 96 steps.
TradePlan trade_plan(const FemCase& fem, TradeGrid grid = {});

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
