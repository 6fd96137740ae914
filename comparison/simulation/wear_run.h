#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "comparison/simulation/fem_case/fem_case.h"
#include "fem/wear/wear_course.h"

namespace fretval {

/// Radius up to which an indenter can wear, over the unit of length: where its height is the largest indentation.
/// Further out its flank stays above the highest plane that the surface of the body reaches.
double widest_wear(const FemCase& fem, double largest_indentation);

/// Ring means of the indenter as wear begins: as it is described, and what it has lost before. rings: of the body.
fem::WornProfile profile_before_wear(const FemCase& fem, const fem::Compliance& rings);

/// Wears a contact at rest, of a case at its resolution, to the end that the case asks for, or goes on from the
/// checkpoint in a folder (empty: none). after_jump: called after each jump with the course so far.
fem::WearCourse worn_to_its_end(std::unique_ptr<fem::RubbingContact> contact, const fem::WornProfile& profile,
                                const FemCase& fem, const Case::WearKinetics& wear,
                                const std::filesystem::path& checkpoints,
                                const std::function<void(const fem::WearCourse&)>& after_jump);

}  // namespace fretval
