#pragma once

#include <string>

#include "comparison/accuracy/prepared_case.h"
#include "tests/comparison/read_case.h"

namespace fretval {

/// As wearing_case, under a normal force of 0.3 N and a tangential displacement or force (`set ENTRY = VALUE`).
inline PreparedCase wearing_under_force(const std::string& tangential) {
  std::string text = elastic_case() + "subsection Wear\n  set Coefficient = 1e-12\nend\n";
  text = replace(text, "Indentation = 1e-4", "Normal force = 0.3");
  text = replace(text, "Normal amplitude = 2e-5", "Normal force amplitude = 0");
  text = replace(text, "set Tangential amplitude = 1.5e-5", tangential);
  text = replace(text, "Tolerance = 0.05", "Tolerance = 1e-3");
  return prepare({read_case(text)}).front();
}

/// A sphere of 10 mm on an elastic rubber, contact radius 1 mm at the largest indentation of 0.1 mm, a quarter of a
/// cycle between its motions: c = 0.594 mm. wear: entries of the section.
inline std::string wearing_text(const std::string& wear) {
  std::string text = elastic_case() + "subsection Wear\n" + wear + "end\n";
  text = replace(text, "Indentation = 1e-4", "Indentation = 8e-5");
  text = replace(text, "Tangential amplitude = 1.5e-5", "Tangential amplitude = 3e-5");
  text = replace(text, "Phase = 60", "Phase = 90");
  return replace(text, "Tolerance = 0.05", "Tolerance = 1e-3");
}

/// motion: an entry that replaces that of its name.
inline PreparedCase wearing_case(const std::string& wear, const std::string& motion = "") {
  std::string text = wearing_text(wear);
  if (!motion.empty()) {
    const auto begin = text.find(motion.substr(0, motion.find('=')));
    text.replace(begin, text.find('\n', begin) - begin, motion);
  }
  return prepare({read_case(text)}).front();
}

}  // namespace fretval
