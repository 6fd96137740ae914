#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/case_parts.h"

namespace fretval {

/// Mean indentation of the cases, m, where they do not say otherwise.
constexpr double usual_indentation = 1e-4;

/// A case of the suite `extremes`, one of a family that goes to the end of one parameter.
struct ExtremeRow {
  std::string family;                   ///< "relaxation time, standard solid"
  std::string value;                    ///< "omega tau = 1e-6"
  Entries entries;                      ///< of its case file
  std::string refusal = {};             ///< words of the message that has to come; empty: an answer has to come
  bool springs = false;                 ///< MDR is held to the transient spring foundation, finite elements refuse
  std::optional<int> ramp_cycles = {};  ///< at least so many cycles are computed; empty: what the tolerance asks for
};

/// What all rows depart from: a parabola of 10 mm on a standard solid with |G|/G'(0) = 1.22, d0 = 0.1 mm,
/// Delta d = 0.2 d0, phase 60 degrees, k = 1, tolerance 1e-2.
Entries extremes_base();

/// The same with an elastic body.
Entries elastic_base();

/// All families. Throws InputError if a case cannot be set up.
std::vector<ExtremeRow> extreme_rows();

/// The first of each family.
std::vector<ExtremeRow> short_extreme_rows();

/// Those whose family contains a text.
std::vector<ExtremeRow> only_family(const std::vector<ExtremeRow>& rows, const std::string& text);

/// The families by theme.
std::vector<ExtremeRow> extreme_material_rows();   ///< moduli, times, friction, units
std::vector<ExtremeRow> extreme_motion_rows();     ///< amplitudes, stick zones, phases, frequencies
std::vector<ExtremeRow> extreme_shape_rows();      ///< indenters
std::vector<ExtremeRow> extreme_numerics_rows();   ///< meshes, steps, cycles
std::vector<ExtremeRow> extreme_bad_input_rows();  ///< values that a case file may not have

}  // namespace fretval
