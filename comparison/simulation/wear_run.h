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

/// Whether wear may move the stick radius: under prescribed forces, and over another body than a half-space.
bool stick_radius_moves(const FemCase& fem);

/// What wear that was computed with the rings graded around an edge came to. Dimensionless.
struct WearPass {
  fem::WearEnd end;
  double largest_indentation, stick_radius;
  double ring;  ///< width of the ring outside of the stick radius
};

/// Edges of the worn flank at the end of wear: the stick radius, and the largest radius that wear can reach.
/// unworn_stick_radius: that of finite elements on the unworn indenter. Under prescribed displacements over a
/// half-space the stick radius stays the same, and the flank is worn to the plane of the largest indentation. Under
/// prescribed forces the indenter sinks in as it wears and the stick radius may move: then wear is computed with the
/// rings graded around it, and again around the stick radius at the end of that, until it moves by no more than a ring.
/// Throws SolverError when it does not settle.
WornEdge settled_edge(const FemCase& fem, double unworn_stick_radius,
                      const std::function<WearPass(const WornEdge&)>& pass_at);

/// Ring means of the indenter as wear begins: as it is described, and what it has lost before. rings: of the body.
fem::WornProfile profile_before_wear(const FemCase& fem, const fem::Compliance& rings);

/// Wears a contact at rest, of a case at its resolution, to the end that the case asks for, or goes on from the
/// checkpoint in a folder (empty: none). after_jump: called after each jump with the course so far.
fem::WearCourse worn_to_its_end(std::unique_ptr<fem::RubbingContact> contact, const fem::WornProfile& profile,
                                const FemCase& fem, const Case::WearKinetics& wear,
                                const std::filesystem::path& checkpoints,
                                const std::function<void(const fem::WearCourse&)>& after_jump);

}  // namespace fretval
