#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// A Prony series as other programs write it; shear moduli in Pa, times in s.
struct PronySeries {
  std::vector<double> moduli, ratios;  ///< of branches; one is empty. Ratios: over the instantaneous modulus
  std::vector<double> times;
  std::optional<double> instantaneous, relaxed;  ///< moduli that the file names
  std::string notes;                             ///< how the file was understood; empty: nothing to tell
};

/// Reads a table with a column of relaxation times (tau) and one of moduli (E_i, G_i, with a unit) or of ratios to the
/// instantaneous modulus (g_i, alpha_i), wherever they stand in it (see mdr/support/csv_columns.h); without names two
/// columns, ratio or modulus first. A line of its own, "E0 = 12 MPa", or a column E_0 of which the first row counts,
/// has the instantaneous modulus, E_inf the relaxed one; G stands for shear, E for Young's moduli, which are divided by
/// 2 (1 + nu). Or an input of Abaqus: *VISCOELASTIC, TIME=PRONY with rows g_i, k_i, tau_i, and *ELASTIC, of which
/// MODULI=INSTANTANEOUS says which modulus it is. Relaxation of the bulk modulus, k_i other than 0, is refused.
///
/// Throws InputError with file and line.
PronySeries read_prony_series(const std::string& file, double poisson_ratio, std::optional<bool> youngs);

/// Relaxed modulus and moduli of the branches, from ratios and whichever modulus is known. Throws InputError, naming
/// the file, if none is, or more than one, or if nothing is left for the relaxed one.
void take_prony_series(const std::string& file, const PronySeries& series, Case::Elastomer& elastomer);

}  // namespace fretval
