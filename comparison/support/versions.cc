#include "comparison/support/versions.h"

#include <deal.II/base/config.h>
#include <dmumps_c.h>
#include <fmt/format.h>
#include <gmsh.h>
#include <petscversion.h>

#include <Eigen/Core>

namespace fretval {

std::vector<std::pair<std::string, std::string>> versions() {
  return {{"fretval", FRETVAL_VERSION},
          {"deal.II", DEAL_II_PACKAGE_VERSION},
          {"PETSc", fmt::format("{}.{}.{}", PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"MUMPS", MUMPS_VERSION},
          {"gmsh", GMSH_API_VERSION},
          {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)}};
}

}  // namespace fretval
