#pragma once

#include <cmath>
#include <string>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {

/// The case of a file called case.prm.
inline Case read_case(const std::string& text = valid_case) {
  const ScratchFolder folder;
  return read_case_file(folder.write("case.prm", text)).at(0);
}

inline PreparedCase prepared_case(const std::string& text = valid_case) {
  return prepare({read_case(text)}).front();
}

/// Of the same shape and motion in an elastic body, at a coarser tolerance.
inline std::string elastic_case() {
  std::string text = replace(valid_case, "standard solid", "elastic");
  text = replace(text, "  set Branch moduli = 1e6\n  set Branch times = 0.1\n", "");
  return replace(text, "Tolerance = 0.01", "Tolerance = 0.05");
}

/// A limiting profile under the normal amplitude of the case, which must be small where most of the contact sticks.
inline Case limiting_case(double stick_ratio, double normal_amplitude = 2e-5) {
  Case input = read_case();
  input.motion.normal_amplitude = normal_amplitude;
  input.motion.tangential_amplitude = std::nan("");
  input.wear = Case::Wear::limiting;
  input.worn_stick_ratio = stick_ratio;
  return input;
}

}  // namespace fretval
