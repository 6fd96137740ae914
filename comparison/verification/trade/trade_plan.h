#pragma once

#include <set>
#include <vector>

#include "comparison/simulation/fem_case.h"
#include "comparison/simulation/resolution.h"

namespace fretval {

/// What a setting of a trade is there for.
enum class Sweep {
  rings,          ///< one axis around the reference
  element_order,  ///< likewise
  grading,        ///< likewise
  far_field,      ///< likewise
  time_step,      ///< likewise
  joint,          ///< rings, order and time steps together: where the front is looked for
  chosen          ///< what `resolution_for` chooses for a tolerance
};
const char* name_of(Sweep sweep);

/// A resolution and every sweep that it belongs to.
struct PlannedSetting {
  Resolution resolution;
  std::set<Sweep> sweeps;
};

/// The spring foundation in time, see mdr::HistoryControl.
struct SpringSetting {
  int n_springs, steps_per_period, n_ramp_periods;
  double periodicity;
};

/// What a trade computes.
struct TradePlan {
  std::vector<double> tolerances;        ///< for which settings are recommended, falling
  Resolution reference;                  ///< the one-axis sweeps vary one of its entries
  std::vector<PlannedSetting> settings;  ///< of the condensed finite elements; no resolution twice
  std::vector<SpringSetting> springs;
  int n_repetitions;             ///< of every measurement of time
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

/// Start, creep and periodicity of the joint sweep go with its time steps as in `resolution_for`, and its far radius
/// with its rings: 12 up to 32 rings, 25 beyond. Its grading is 0.3; the rings at a worn edge are those for 1e-3
/// throughout. An unlocked phase makes histories long: then at most 48 rings and 96 steps. Times are measured twice;
/// with an unlocked phase, a dashpot or a worn edge, once.
TradePlan trade_plan(const FemCase& fem, const TradeAxes& axes = {});

}  // namespace fretval
