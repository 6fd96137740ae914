#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace fretval::mdr {

/// The message of the std::invalid_argument that an action ends in; "accepted" if it does not.
inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace fretval::mdr
