#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/accuracy/proof.h"

namespace fretval {

/// `fretval run`: MDR and finite elements, compared; writes the results and the report. Returns the exit code.
int run_cases(const std::vector<std::string>& files, const std::filesystem::path& output, Proof proof);

}  // namespace fretval
