#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fem/support/solver_error.h"

namespace fretval::fem {

/// Expects a SolverError whose message has all the given parts.
template <typename Action>
void expect_solver_error(const Action& action, const std::vector<std::string>& parts) {
  try {
    action();
    FAIL() << "no error, expected one with " << parts[0];
  } catch (const SolverError& error) {
    const std::string message = error.what();
    for (const auto& part : parts) EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks: " << part;
  }
}

}  // namespace fretval::fem
