#pragma once

#include <filesystem>

#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// Writes fields of the last period of an answer into a folder, for ParaView: fields.pvd, the plane in which the
/// indenter moves, and surface.pvd, the surface around it, which list fields/section-NN.vtu and fields/surface-NN.vtu,
/// see fem/condensation/meridian_section.h and revolved_surface.h. Such files of an earlier run are removed; with
/// Fields::none, or for an answer in which the whole contact slides, nothing else is done. fem_case: the case at the
/// resolution of the answer.
void write_field_files(const FeAnswer& fe, const FemCase& fem_case, Case::Fields fields,
                       const std::filesystem::path& folder);

}  // namespace fretval
