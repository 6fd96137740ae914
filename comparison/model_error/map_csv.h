#pragma once

#include <string_view>

namespace fretval {

/// map.csv, which is compiled into the program.
extern const std::string_view map_csv;

}  // namespace fretval
