#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/case_file/entry_reader.h"

namespace fretval {

/// The sections of a case file that describe the case. Measured tables are read, and moduli fitted, here: what follows
/// sees numbers. notes: what was skipped in tables, and how they were processed.
Case::Indenter read_indenter(const EntryReader& entries, std::vector<std::string>& notes);
/// tangential: whether the indenter moves tangentially, against which a frictionless base holds nothing.
Case::Body read_body(const EntryReader& entries, bool tangential);

Case::Motion read_motion(const EntryReader& entries, std::vector<std::string>& notes);

/// motion: where it goes in two directions, friction has to be a vector.
Case::Contact read_contact(const EntryReader& entries, const Case::Motion& motion);

/// Path of a table of radii and heights, with units; empty where there is a problem, which is noted.
std::string read_table_path(const EntryReader& entries, const std::string& section, const std::string& name,
                            std::vector<std::string>& notes);

/// warnings: about measured moduli that fit badly or contradict themselves.
Case::Elastomer read_elastomer(const EntryReader& entries, std::vector<std::string>& warnings,
                               std::vector<std::string>& notes);

/// Everything but the name. Throws InputError with everything that is wrong.
Case read_entries(const EntryReader& entries, Accuracy accuracy);

/// The subsection Measured; empty if nothing is set there. notes: what was skipped in the table of loops.
std::optional<Case::Measured> read_measured(const EntryReader& entries, std::vector<std::string>& notes);

/// The relaxed modulus of an elastomer that is no table: read from an entry, or from a hardness. Problems are noted.
/// notes: what was derived from what.
void read_relaxed_modulus(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

/// Reads the branches of an elastomer, moduli or ratios, and times, from entries or from a file (branches_file.h). To
/// be called after read_relaxed_modulus(); with ratios and an instantaneous modulus the relaxed one follows here.
void read_branches(const EntryReader& entries, Case::Elastomer& elastomer, std::vector<std::string>& notes);

/// Reads the entries of a body with a given mesh: Mesh, Mesh unit and Relative moduli. The file is read and audited
/// here, so that all that is wrong with it is bad input. Sets the mesh and the thickness, which is how far down the
/// axis reaches.
void read_mesh_entries(const EntryReader& entries, Case::Body& body);

/// Whether the base of the body is a plane, as a base without friction has to be.
bool has_level_base(const meshes::Mesh& mesh);

/// The relative moduli of the materials of a mesh, in their order.
std::vector<double> moduli_of_materials(const Case::Body& body);

}  // namespace fretval
