#pragma once

#include <fmt/format.h>

#include "tests/comparison/run_fretval.h"

namespace fretval {

/// Runs the program on so many ranks; a hang is ended after two minutes, with exit code 124. before: shell commands of
/// each rank. The environment is new, but for the kernels of BLAS, on which digits depend: that of the tests is one of
/// a process that MPI runs in.
inline Run ranked_run(int n_ranks, const std::string& arguments, const ScratchFolder& folder,
                      const std::string& before = "") {
  const auto command = fmt::format("{} exec {} {}", before, FRETVAL_PROGRAM, arguments);
  return shell_run(
      fmt::format("cd {} && env -i PATH=\"$PATH\" HOME={} OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                  "$(env | grep ^OPENBLAS_) timeout 120 mpirun --oversubscribe -n {} sh -c {}",
                  quoted(folder.path()), quoted(folder.path()), n_ranks, quoted(command)),
      folder);
}

}  // namespace fretval
