#pragma once

#include <optional>
#include <string>

#include "comparison/command_line/store_command.h"

namespace fretval {

struct TrustOptions {
  bool json = false;
  std::optional<double> at_most;  ///< largest share by which MDR may be off; empty: any
  std::string output;             ///< folder of a report; empty: none
  std::string map;                ///< file of the maps; empty: a case
  StoreOptions store;
};

/// "5 %" or "0.05" as a share. Throws InputError for others, naming the option.
double share_of(const std::string& text, const char* option = "--at-most");

/// Prints how far MDR can be trusted in the single case of a file, and why; returns the exit code: that of
/// disagreement where a radius is off by more than at_most for sure. Throws InputError, also for a sweep.
int run_trust(const std::string& file, const TrustOptions& options);

/// Computes the maps of MDR's error (trust/map.h) and writes them to the file, which is replaced when all is there.
int run_map(const TrustOptions& options);

}  // namespace fretval
