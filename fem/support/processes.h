#pragma once

namespace fretval::fem {

/// One of the processes that mpirun (or srun) has started together.
struct Process {
  int number = 0;  ///< from 0
  int count = 1;   ///< of the processes; 1: it was started alone
};

/// This process according to its environment, also before MPI is started: it reads the variables of Open MPI's mpirun,
/// of PMI, and of Slurm's srun with PMIx.
Process this_process();

/// Whether mpirun or srun has started this process, alone or with others.
bool is_started_by_mpirun();

}  // namespace fretval::fem
