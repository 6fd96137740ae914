#pragma once

#include <string>

#include "fem/wear/wear_course.h"

namespace fretval::fem {

/// All that a wear needs to go on, bit for bit, as bytes that the program which wrote them reads.
std::string archived(const WearState& state);

/// Puts a state where its archive was made. The contact of the state was made of the same arguments. Throws
/// std::runtime_error for bytes that are no archive; the state is void then.
void restore(const std::string& bytes, WearState& state);

}  // namespace fretval::fem
