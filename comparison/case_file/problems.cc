#include "comparison/case_file/problems.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/case/case.h"

namespace fretval {

void Problems::add(const std::string& message) {
  if (std::find(messages.begin(), messages.end(), message) == messages.end()) messages.push_back(message);
}

void Problems::throw_if_any() const {
  if (!messages.empty()) throw InputError(fmt::format("{}", fmt::join(messages, "\n")));
}

}  // namespace fretval
