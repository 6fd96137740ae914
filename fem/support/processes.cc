#include "fem/support/processes.h"

#include <array>
#include <cstdlib>

namespace fretval::fem {
namespace {

struct Launcher {
  const char *number, *count;
};

// srun sets SLURM_PROCID for programs without MPI as well: it is asked only for the count beside the rank of PMIx.
constexpr std::array<Launcher, 3> launchers{{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                             {"PMI_RANK", "PMI_SIZE"},
                                             {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}};

}  // namespace

Process this_process() {
  for (const auto& [number, count] : launchers)
    if (std::getenv(number) && std::getenv(count))
      return {std::atoi(std::getenv(number)), std::atoi(std::getenv(count))};
  return {};
}

bool is_started_by_mpirun() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_RANK") != nullptr;
}

}  // namespace fretval::fem
