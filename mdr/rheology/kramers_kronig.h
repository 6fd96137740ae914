#pragma once

#include <string>
#include <vector>

#include "mdr/rheology/modulus_table.h"

namespace fretval::mdr {

/// Whether the loss modulus of a table follows from its storage modulus, as it must for any linear causal body.
/// Judged at means of the table over quarters of a decade.
struct KramersKronig {
  std::vector<double> frequency;  ///< of the judged points, Hz
  std::vector<double> deviation;  ///< (loss modulus from the storage modulus)/(measured) - 1
  std::vector<double> allowed;    ///< for the size of each deviation
  double worst;                   ///< the deviation that is the largest multiple of what is allowed for it
  double frequency_at_worst;      ///< Hz
  double rms;                     ///< root mean square deviation, weighted with 1/allowed^2
  bool consistent;                ///< no deviation is above what is allowed
};

/// Why a table is too sparse for the check: fewer than 8 frequencies, less than a decade, or a gap of over a decade,
/// which it names; empty: it can be judged. Throws std::invalid_argument for an invalid table.
std::string too_sparse_for_kramers_kronig(const ModulusTable& table);

/// Kramers-Kronig relation in the form whose kernel decays as |omega'/omega|^(-1) to either side:
///
///   G''(omega) = (1/pi) int (dG'/dy) ln coth|y/2| dy,    y = ln(omega'/omega)
///
/// of which Booij and Thoone, Rheologica Acta 21 (1982) 15, take the narrow kernel alone: G'' = (pi/2) dG'/dln(omega).
/// G' is taken as linear in log frequency between the means. Outside the measured range it may rise as suits the
/// measured loss best, but not fall: the check reports only what no continuation of the table can explain. It uses
/// no relaxation times and is independent of fit_prony.
///
/// Allowed are 10 %, twice the error of the quadrature for a single relaxation time, and five standard deviations for
/// the noise, whose size is taken from the scatter of the table about smooth curves. Where G'' is small beside G' it is
/// judged less sharply: noise of G' enters multiplied by about G'/(2 G'').
///
/// Throws std::invalid_argument for an invalid table, and for one that is too sparse.
KramersKronig kramers_kronig(const ModulusTable& table);

}  // namespace fretval::mdr
