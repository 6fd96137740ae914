#pragma once

#include <string>

namespace fretval {

struct MdrOptions {
  bool json = false;
  bool springs = false;  ///< also the transient spring foundation
  std::string fields;    ///< CSV file for the fields on the surface; empty: none
};

/// Prints the analytic answer to each case of a file, also to cases that finite elements do not cover; returns the exit
/// code. Throws InputError.
int run_mdr(const std::string& file, const MdrOptions& options);

}  // namespace fretval
