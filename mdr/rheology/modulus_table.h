#pragma once

#include <complex>
#include <istream>
#include <string>
#include <vector>

#include "mdr/support/csv.h"

namespace fretval::mdr {

/// Measured complex shear modulus G' + i G'' over frequency. All columns have the same length, at least 2.
struct ModulusTable {
  std::vector<double> frequency;  ///< Hz, positive, strictly increasing
  std::vector<double> storage;    ///< G' in Pa, positive
  std::vector<double> loss;       ///< G'' in Pa, positive
};

/// Throws std::invalid_argument unless the table is as described above.
void validate(const ModulusTable& table);

/// Reads the columns frequency, storage and loss modulus (see read_csv). Rows are sorted by frequency; rows of exactly
/// the same frequency become one with the means of their moduli.
///
/// Units are those that the second header line names, or else the brackets in the names, "G' [MPa]": Pa, kPa, MPa or
/// GPa, and Hz or rad/s. Without any they are Pa and Hz. Moduli are then multiplied by factor. A table of Young's
/// moduli is not recognised as such: pass factor = 1/3, which is G/E of an incompressible body.
///
/// A third column whose name begins with "tan" is the loss factor tan delta = G''/G' instead, without a unit or in %.
///
/// Throws std::invalid_argument that names the source and line of a value that is not positive, an unknown unit, or
/// fewer than two frequencies.
ModulusTable read_modulus_table(std::istream& stream, const std::string& source_name, double factor = 1);

/// Whether the third column is the loss factor; its header says so.
bool has_loss_factor(const CsvColumns& csv);

/// Complex modulus in Pa at the angular frequency omega in rad/s, by interpolation of log G' and log G'' over log
/// frequency: exact for power laws, error of order (spacing of log frequency)^2 otherwise. Throws
/// std::invalid_argument outside the measured range, which it names; an excess of 1e-12 of it counts as roundoff.
std::complex<double> complex_modulus(const ModulusTable& table, double omega);

}  // namespace fretval::mdr
