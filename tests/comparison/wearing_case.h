#pragma once

#include <string>

#include "comparison/accuracy/prepared_case.h"
#include "tests/comparison/read_case.h"

namespace fretval {

/// A sphere of 10 mm on an elastic rubber, contact radius 1 mm at the largest indentation of 0.1 mm, a quarter of a
/// cycle between its motions: c = 0.594 mm. wear: entries of the section; motion: one that replaces that of its name.
inline PreparedCase wearing_case(const std::string& wear, const std::string& motion = "") {
  std::string text = R"(subsection Indenter
  set Shape = parabola
  set Radius = 1e-2
end
subsection Elastomer
  set Rheology = elastic
  set Relaxed shear modulus = 1e6
end
subsection Friction
  set Coefficient = 0.5
  set Law = unidirectional
end
subsection Motion
  set Indentation = 8e-5
  set Normal amplitude = 2e-5
  set Normal frequency = 1
  set Tangential amplitude = 3e-5
  set Tangential frequency = 1
  set Phase = 90
end
subsection Accuracy
  set Tolerance = 1e-3
end
subsection Wear
)" + wear + "end\n";
  if (!motion.empty()) {
    const auto begin = text.find(motion.substr(0, motion.find('=')));
    text.replace(begin, text.find('\n', begin) - begin, motion);
  }
  return prepare({read_case(text)}).front();
}

}  // namespace fretval
