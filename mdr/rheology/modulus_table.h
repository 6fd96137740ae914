#pragma once

#include <complex>
#include <istream>
#include <string>
#include <vector>

#include "mdr/support/csv_columns.h"

namespace fretval::mdr {

/// Measured complex shear modulus G' + i G'' over frequency. All columns have the same length, at least 2.
struct ModulusTable {
  std::vector<double> frequency;  ///< Hz, positive, strictly increasing
  std::vector<double> storage;    ///< G' in Pa, positive
  std::vector<double> loss;       ///< G'' in Pa, positive
};

/// Throws std::invalid_argument unless the table is as described above.
void validate(const ModulusTable& table);

/// What a table of moduli has to have: frequency, storage modulus, and loss modulus or loss factor.
const std::vector<WantedColumn>& modulus_columns();

/// Reads frequency, storage modulus and loss modulus wherever they stand in a table (see read_columns); columns that
/// neither a name nor a unit tells apart are taken in this order. Rows are sorted by frequency; rows of exactly the
/// same frequency become one with the means of their moduli.
///
/// Units: Pa, kPa, MPa, GPa or N/mm^2, and Hz, kHz, mHz or rad/s. Without any they are Pa and Hz. Moduli are then
/// multiplied by factor. A table of Young's moduli is not recognised as such: pass factor = 1/3, which is G/E of an
/// incompressible body.
///
/// A loss factor tan delta = G''/G' may stand in the place of the loss modulus, without a unit or in %.
///
/// Throws std::invalid_argument that names the source and line of a value that is not positive, an unknown unit, or
/// fewer than two frequencies.
ModulusTable read_modulus_table(std::istream& stream, const std::string& source_name, double factor = 1);

/// Whether the third of the chosen columns is the loss factor in the place of the loss modulus.
bool has_loss_factor(const ChosenColumns& chosen);

/// Complex modulus in Pa at the angular frequency omega in rad/s, by interpolation of log G' and log G'' over log
/// frequency: exact for power laws, error of order (spacing of log frequency)^2 otherwise. Throws
/// std::invalid_argument outside the measured range, which it names; an excess of 1e-12 of it counts as roundoff.
std::complex<double> complex_modulus(const ModulusTable& table, double omega);

}  // namespace fretval::mdr
