#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Fits a Prony body to a CSV file of measured moduli and fills in the elastomer's numbers and its master_curve.
/// youngs: the file has Young's moduli, E = 2 (1 + nu) G with the elastomer's Poisson's ratio.
/// warnings: moduli that contradict Kramers and Kronig, a fit that is bad or goes far below the measured moduli, and a
/// relaxed modulus that is extrapolated.
/// Throws InputError with the file's name.
void fit_master_curve(const std::string& file, bool youngs, Case::Elastomer& elastomer,
                      std::vector<std::string>& warnings);

/// Range in which the relaxed modulus may lie, Pa.
struct RelaxedModulusRange {
  double least, most;
};

/// The range of the relaxed modulus where tan delta is above 0.1 at the lowest frequency f, so that G'(0) lies below
/// what was measured. G' has no more to fall than G'(f), if the body is at rest there but for much faster branches; and
/// it falls by (2/pi) int G'' dln f below f (Kramers and Kronig, as for a broad spectrum), where G'' goes on with the
/// slope that it has over the lowest decade. The fitted modulus is in the range. Empty: the table reaches the plateau.
std::optional<RelaxedModulusRange> extrapolated_range(const Case::MasterCurve& data, double fitted);

}  // namespace fretval
