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

/// The indenter of wearing_text goes in a circle of 40 um at a constant depth of 0.1 mm, with friction as a vector, on
/// so few rings and steps that it wears in seconds: by MDR c^2 = 1 - 0.8/3, in units of the contact radius.
inline std::string wearing_in_a_circle_text() {
  std::string text = elastic_case() + "subsection Wear\n  set Coefficient = 1e-12\nend\n";
  text = replace(text, "Normal amplitude = 2e-5", "Normal amplitude = 0");
  text = replace(text, "Tangential amplitude = 1.5e-5",
                 "Tangential amplitude = 2e-5\n  set Transverse amplitude = 2e-5\n  set Transverse phase = 90");
  text = replace(text, "Phase = 60", "Phase = 0");
  text += "subsection Contact\n  set Friction = vector\nend\n";
  return text + "subsection Accuracy\n  set Rings per radius = 16\n  set Steps per cycle = 16\nend\n";
}

inline PreparedCase wearing_in_a_circle(const std::string& more = "") {
  return prepare({read_case(wearing_in_a_circle_text() + more)}).front();
}

/// The same under the constant force that presses it in by 0.1 mm.
inline PreparedCase wearing_in_a_circle_under_a_weight() {
  auto text = replace(wearing_in_a_circle_text(), "Indentation = 1e-4", "Normal force = 0.5333333");
  return prepare({read_case(replace(text, "Normal amplitude = 0", "Normal force amplitude = 0"))}).front();
}

}  // namespace fretval
