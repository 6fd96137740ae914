#pragma once

#include "mdr/support/constants.h"

namespace fretval {

using mdr::pi;

}  // namespace fretval
