#pragma once

#include <optional>

#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr {

/// Where an indenter that follows a force is at the end of a step, with the rates of SpringStep::arrived. As a function
/// of its position the load of all springs is piecewise linear (SpringStep::normal_lines, tangential_lines), and
/// Newton's method is exact once it is on the right piece: 2 to 4 passes over the springs. Where springs with a dashpot
/// touch, their load jumps, and the force may be one that no position gives: the indenter is at the jump then.

/// The indentation in m at which sum(width * normal_load) is `load`, positive, in m^2. Throws std::invalid_argument.
double indentation_for_load(const SpringStep& step, const SpringState& state, const SpringBed& bed, double load);

/// The tangential displacement in m at which sum(width * tangential_load) is `load` in m^2, for an indentation already
/// found. Throws GrossSlip when friction cannot carry it.
double tangential_for_load(const SpringStep& step, const SpringState& state, const SpringBed& bed, double indentation,
                           double load);

/// What a rig prescribes at the end of a step: where the indenter is or, in the place of either direction, a load
/// sum(width * load) in m^2.
struct PrescribedInStep {
  IndenterState indenter;
  std::optional<double> normal_load, tangential_load;
};

/// The position and the rates of the indenter at the end of a step, in which prescribed loads are balanced. Throws as
/// indentation_for_load() and tangential_for_load() do.
IndenterState balanced(const SpringStep& step, const SpringState& state, const SpringBed& bed,
                       const PrescribedInStep& prescribed);

/// The indentation in m at which springs that have relaxed for ever bear a force in N, positive.
double relaxed_indentation(const SpringBed& bed, const PronyBody& body, double force);

}  // namespace fretval::mdr
