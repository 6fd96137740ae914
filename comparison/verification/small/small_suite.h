#pragma once

#include <filesystem>
#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// The CI check: a few small cases on the two committed meshes of meshes/small. Each is there twice, on the coarse and
/// on the fine mesh, with the tolerances that the ring width of the mesh allows, and without error bars.
/// meshes: folder with coarse.msh and fine.msh. Throws InputError or meshes::MeshError if the files are damaged.
std::vector<SuiteCase> small_cases(const std::filesystem::path& meshes);

/// The folder of the committed meshes.
std::filesystem::path small_meshes();

SuiteRun run_small_suite(const std::filesystem::path& meshes);

}  // namespace fretval
