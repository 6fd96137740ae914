#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/results/batch.h"

namespace fretval {

/// The CI check: a few small cases on the two committed meshes of meshes/small. Each case is there twice, on the
/// coarse and on the fine mesh, with the tolerances that the ring width of the mesh allows.
struct SmallCase {
  PreparedCase prepared;
  std::filesystem::path mesh;
};

/// meshes: folder with coarse.msh and fine.msh.
std::vector<SmallCase> small_cases(const std::filesystem::path& meshes);

/// The folder of the committed meshes.
std::filesystem::path small_meshes();

/// Runs the cases; one line each, in their order. Throws InputError or meshes::MeshError if the committed files are
/// damaged.
std::vector<BatchLine> run_small_suite(const std::vector<SmallCase>& cases);

/// JUnit XML of the lines, for CI systems.
std::string junit_xml(const std::vector<BatchLine>& lines);

}  // namespace fretval
