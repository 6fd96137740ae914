#pragma once

#include <map>
#include <string>
#include <vector>

namespace fretval {

/// What a new case file begins with.
struct NewCase {
  std::string shape = "parabola";           ///< as in a case file
  std::string rheology = "standard solid";  ///< as in a case file
};

/// The shapes and rheologies to choose from.
const std::vector<std::string>& new_case_shapes();
const std::vector<std::string>& new_case_rheologies();

/// A case file, every entry with its meaning, and the tables that it names, by file name: stem.prm and, for measured
/// shapes and bodies, stem-profile.csv and stem-moduli.csv, which hold a sphere and a standard solid to be replaced.
/// Finite elements confirm MDR's answer to this case. Throws InputError, naming what would be valid, for another
/// choice.
std::map<std::string, std::string> new_case_files(const std::string& stem, const NewCase& choice);

}  // namespace fretval
