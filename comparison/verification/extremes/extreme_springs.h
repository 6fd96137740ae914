#pragma once

#include "comparison/verification/suite.h"

namespace fretval {

/// MDR's stick radii against the transient spring foundation, for motions that finite elements refuse. The bar is three
/// times the difference made by half as many springs and steps. Throws InputError, std::runtime_error if the springs do
/// not become periodic.
ComparedQuantities compared_with_springs(const Case& input);

}  // namespace fretval
