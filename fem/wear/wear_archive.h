#pragma once

#include <string>

#include "fem/wear/wear_course.h"

namespace fretval::fem {

/// All that wear needs to go on, bit for bit, as bytes; they are to be read by the program that wrote them.
std::string archived(const WearState& state);

/// Sets a state to the one that was archived. Its contact has to have been made of the same arguments. Throws
/// std::runtime_error for bytes that are no archive; the state is void then.
void restore(const std::string& bytes, WearState& state);

}  // namespace fretval::fem
