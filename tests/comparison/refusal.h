#pragma once

#include <functional>
#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Message of the InputError, which ends in exit code 2; "no error" if there is none.
inline std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace fretval
