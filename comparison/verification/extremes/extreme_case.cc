#include "comparison/verification/extremes/extreme_case.h"

namespace fretval {

Entries extremes_base() {
  return {{"Indenter / Shape", "parabola"},
          {"Indenter / Radius", "1e-2"},
          {"Elastomer / Rheology", "standard solid"},
          {"Elastomer / Relaxed shear modulus", "1e6"},
          {"Elastomer / Branch moduli", "1e6"},
          {"Elastomer / Branch times", "0.1"},
          {"Friction / Coefficient", "0.5"},
          {"Friction / Law", "unidirectional"},
          {"Motion / Indentation", "1e-4"},
          {"Motion / Normal amplitude", "2e-5"},
          {"Motion / Normal frequency", "1"},
          {"Motion / Tangential amplitude", "1.5e-5"},
          {"Motion / Tangential frequency", "1"},
          {"Motion / Phase", "60"},
          {"Accuracy / Tolerance", "1e-2"}};
}

std::string extremes_table(const std::string& file) {
  return std::string(FRETVAL_EXTREMES_CASES) + "/" + file;
}

}  // namespace fretval
