#include <benchmark/benchmark.h>

#include "fem/condensation/petsc_session.h"

// Of benchmarks that factorise: PETSc and MUMPS live as long as the program.
int main(int argc, char** argv) {
  const fretval::fem::PetscSession session;
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
