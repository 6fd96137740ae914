#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparison/simulation/fem_case/fem_case.h"

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

}  // namespace fretval
