#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "mdr/support/csv.h"

namespace fretval::mdr {

/// Sizes of units in m, Pa, s, N and 1. Micro is u, or either sign of it.
const std::map<std::string, double>& length_units();
const std::map<std::string, double>& modulus_units();
const std::map<std::string, double>& time_units();
const std::map<std::string, double>& force_units();
const std::map<std::string, double>& ratio_units();

/// "MPa" of "G' (storage) [MPa]", of the last brackets; the text itself if there are none.
std::string unit_text(const std::string& text);

/// Whether the header names a unit of the column: in its second line, or in brackets in the column's name.
bool names_unit(const CsvColumns& csv, std::size_t column);

/// Size of a column's unit in the base unit: of the unit that the second header line names, or else of that in brackets
/// in the column's name, "G' [MPa]"; 1 if the header names none. Throws std::invalid_argument that names the source,
/// the column and the known units for any other.
double unit_of_column(const CsvColumns& csv, std::size_t column, const std::map<std::string, double>& known,
                      const std::string& source_name);

}  // namespace fretval::mdr
