#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "comparison/simulation/fem_case.h"

namespace fretval {

/// An entry of the resolution that a trade varies alone, the others at a reference.
struct TradeAxis {
  const char* name;
  double (*value)(const Resolution&);
  bool finer_is_smaller = false;
  bool has_order = true;  ///< the error is expected to go like a power of it
};
const std::array<TradeAxis, 5>& trade_axes();

/// What a trade computes.
struct TradePlan {
  std::vector<double> tolerances;  ///< for which settings are recommended, falling
  Resolution reference;
  /// Settings of the condensed finite elements, and what each is there for: the names of axes, "joint" (rings, order
  /// and time steps together: where the front is looked for), "chosen" (by `resolution_for` for a tolerance).
  std::map<Resolution, std::set<std::string>> settings;
  std::vector<Resolution> full;  ///< also stepped with every degree of freedom; each one of `settings`
};

/// The values of the axes, before they are combined.
struct TradeAxes {
  std::vector<unsigned> rings{8, 12, 16, 24, 32, 48, 64, 96, 128}, degrees{2, 3, 4}, joint_degrees{2, 3};
  std::vector<double> growths{0.15, 0.3, 0.6}, far_radii{3, 6, 12, 25};
  std::vector<int> steps{12, 24, 48, 96, 192};
  std::vector<unsigned> full_rings{8, 16};
  std::vector<double> tolerances{1e-2, 1e-3, 1e-4};
};

/// The resolution that `resolution_for` chooses for a case.
Resolution chosen_resolution(double tolerance, const FemCase& fem);

/// Start, creep and periodicity of the joint settings go with their time steps as in `resolution_for`, and their far
/// radius with their rings: 12 up to 32 rings, 25 beyond. Their grading is 0.3; the rings at a worn edge are those for
/// 1e-3 throughout. An unlocked phase makes histories long: then at most 48 rings and 96 steps.
TradePlan trade_plan(const FemCase& fem, const TradeAxes& axes = {});

}  // namespace fretval
