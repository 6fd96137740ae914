#pragma once

#include <string>
#include <vector>

namespace fretval {

struct JUnitCase {
  std::string name;
  std::string failure;      ///< empty: passed
  std::string output = {};  ///< the result for people; empty: not told
  double seconds = 0;       ///< 0: not told
  std::string error = {};   ///< why there is no answer at all, which is no failure of an answer; empty: there is one
};

/// JUnit XML of a suite, for CI systems. name: of the suite; with dots for its spaces it is the class of
/// the cases.
std::string junit_document(const std::string& name, const std::vector<JUnitCase>& cases);

}  // namespace fretval
