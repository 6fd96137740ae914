#pragma once

#include "comparison/case/case.h"
#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// Reads the entries of a body with a given mesh: Mesh, Mesh unit and Relative moduli. The file is read and audited
/// here, so that all that is wrong with it is bad input. Sets the mesh and the thickness, which is how far down the
/// axis reaches.
void read_mesh_entries(const EntryReader& entries, Case::Body& body);

/// Whether the base of the body is a plane, as a base without friction has to be.
bool has_level_base(const meshes::Mesh& mesh);

/// The relative moduli of the materials of a mesh, in their order.
std::vector<double> moduli_of_materials(const Case::Body& body);

}  // namespace fretval
