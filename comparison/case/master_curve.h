#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Fits a Prony body to a CSV file of measured moduli and fills in the elastomer's numbers and its master_curve.
/// youngs: the file has Young's moduli, E = 2 (1 + nu) G with the elastomer's Poisson's ratio.
/// warnings: moduli that contradict Kramers and Kronig, and a fit that is bad or goes far below the measured moduli.
/// Throws InputError with the file's name.
void fit_master_curve(const std::string& file, bool youngs, Case::Elastomer& elastomer,
                      std::vector<std::string>& warnings);

}  // namespace fretval
