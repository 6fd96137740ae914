#pragma once

#include <map>
#include <string>

#include "comparison/case/case.h"
#include "comparison/verification/extremes/extremes.h"

namespace fretval {

/// MDR's stick radii against the transient spring foundation, for motions that finite elements refuse. The bar is three
/// times the difference made by half as many springs and steps. Throws InputError, std::runtime_error if the springs do
/// not become periodic.
std::map<std::string, ExtremeError> spring_errors(const Case& scene);

}  // namespace fretval
