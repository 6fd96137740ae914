#pragma once

#include <filesystem>

#include "comparison/case/case.h"
#include "mdr/rheology/prony_body.h"

namespace fretval {

/// Writes moduli.csv: storage and loss modulus of a body with memory over the frequencies of the motion, of its
/// branches and of the measured moduli, and a decade beyond on either side. measured_moduli.csv: what was measured, at
/// the temperature of the case. Neither for an elastic body.
void write_moduli(const Case& input, const mdr::PronyBody& body, const std::filesystem::path& folder);

}  // namespace fretval
