#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "comparison/accuracy/quantity.h"
#include "comparison/case/case.h"

namespace fretval {

/// Unit of a swept entry: "deg", or empty. entry: as in Case::Sweep.
std::string unit_of_entry(const std::string& entry);

/// What heads its column in a CSV file: "Motion / Phase [deg]".
std::string column_of_entry(const std::string& entry);

/// MDR's answer between the points of each sweep among the cases, in two files in the folder of the family. `mdr.csv`:
/// what has a closed form (both stick radii, contact radius, outer radius of the wear), at some hundred values.
/// `mdr_springs.csv`: also what springs are stepped in time for, at some 24 values; not of a phase or a stick radius
/// ratio, of which the paper's figures have dozens of families, unless it is the only sweep. Columns: the entry, then
/// the quantities, "nan" where there is none. Nothing is written for prescribed forces and several normal harmonics,
/// whose radii need springs too, and for measured moduli, which would be fitted for each value; nor where the entry
/// does not take values between.
void write_sweep_lines(const std::vector<Case>& cases, const std::filesystem::path& output);

/// A quantity of it over the entry; empty where there is none. family: its folder.
std::pair<std::vector<double>, std::vector<double>> read_sweep_line(const std::filesystem::path& family,
                                                                    const std::string& entry, Quantity quantity);

}  // namespace fretval
