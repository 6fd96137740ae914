#pragma once

#include <complex>

#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// What steps of length dt make of stiffening_at(omega): the response of RelaxationStep to displacements that are
/// exp(i omega t) at the ends of steps and linear between them, as of a ring that follows a force, over the relaxed
/// modulus and what they are at the balance time.
///
/// With branches shorter than a step it errs by less in long steps than in shorter ones: of two branches that relax in
/// 1/252 and 1/158 of a period, and are 16 and 4.5 times as stiff as the relaxed body, a force of known amplitude moves
/// the indenter by 3.7e-3, 4.7e-3, 3.1e-3 and 1.1e-3 too far in 16, 32, 64 and 128 steps.
std::complex<double> stepped_stiffening_at(const RelaxationModel& relaxation, double omega, double dt);

}  // namespace fretval::fem
