#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fretval {

/// A text has all of these parts.
inline void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const auto& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
}

}  // namespace fretval
