#pragma once

#include <string>

#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/proof.h"
#include "comparison/accuracy/wear_computations.h"
#include "comparison/reference/mdr_wear.h"
#include "comparison/simulation/surface_wear.h"

namespace fretval {

/// The wear of a case under friction as a vector, beside the limit that MDR says it tends to.
struct ProvedSurfaceWear {
  SurfaceWear fe;  ///< answer at the resolution below
  std::string failure = {};
  Resolution resolution;
  WearLimit limit;         ///< by MDR
  bool is_proved = false;  ///< whether there are bars
  /// Error bars: of radius and extents of the zone that sticks at the end, over the unit of length, and of the worn
  /// volume, over the volume by finite elements.
  ErrorBar radius = {}, along = {}, across = {}, volume = {};
  ProofCost cost = {};
};

/// Runs the wear of a case, and measures its errors by half of the rings, steps and angles, and jumps twice as long.
/// Each error is of first order at worst, and so not larger than the change by halving; the edge of the zone is known
/// to a ring. As this is another model than MDR's, no tolerance is asked for, and nothing is refined.
ProvedSurfaceWear prove_surface_wear(const PreparedCase& prepared, const MdrAnswer& mdr, const ProvedAnswer& unworn,
                                     Proof proof, BodyStore& bodies, const WearOversight& oversight = {});

}  // namespace fretval
