#pragma once

#include "tests/meshes/block.h"
#include "tests/meshes/expect_error.h"

namespace fretval::meshes {

/// Expects that a step of the audit finds a defect, and says "block.msh: " and the given parts.
template <typename Step>
void expect_defect(const Step& step, const Mesh& mesh, std::vector<std::string> parts) {
  parts.emplace_back("block.msh: ");
  expect_error([&] { step(mesh, "block.msh"); }, parts);
}

}  // namespace fretval::meshes
