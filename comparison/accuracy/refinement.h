#pragma once

#include <optional>
#include <vector>

#include "comparison/simulation/fem_case/fem_case.h"

namespace fretval {

/// Where an error comes from. The error of the data is not one of the numerics: both methods share it.
enum class ErrorSource {
  rings,
  angles,
  element_order,
  grading,
  far_field,
  time_step,
  start,
  creep,
  cycles,
  wear_jump,
  edge,
  instants,
  data
};
const char* name_of(ErrorSource source);

/// A resolution that differs from a reference in one respect: coarser, or finer where coarser does not exist.
struct Variant {
  ErrorSource source;
  Resolution resolution, reference;
};

/// Whether the case file fixes rings or steps, which are not refined then.
struct FixedByCase {
  bool rings, steps;
};

/// What the errors of a case depend on: an elastic body has no memory of its start, a single pass starts as it does, a
/// locked phase does not creep, the rings of a worn profile are graded, and rings that touch are held from the start of
/// their step on with a dashpot or under a tangential force (see fem::FrictionContact), or where rings touch in any
/// order; there zones end with rings, and what is read of them is of first order. A stick radius next to the edge of
/// the smallest contact is of first order, too, as the last rings of that are loaded or free as a whole (1.5e-4, 8e-5,
/// 4e-5, 2e-5 of a contact radius at 16 to 128 rings).
struct CaseNeeds {
  explicit CaseNeeds() = default;  // no list of values without their names
  bool memory = true, creep = false, held_from_start = false;
  ContactKind kind = ContactKind::discs;
  MotionKind motion_kind = MotionKind::cycles;
  bool first_slip_ends_with_contact = false, shakedown_ends_with_contact = false;
  /// All relations of the phases come by in the course of many cycles: an unlocked phase, or frequencies without a
  /// common period.
  bool without_period = false;
  /// A branch relaxes within two steps: an order in the step that coarser steps seem to show is not believed.
  bool has_short_branch = false;
  /// The indenter follows a tangential force or the rows of a path, step by step: errors of rings and steps depend on
  /// each other.
  bool moves_by_steps = false;
  /// It repeats and is made of cosines, so that its first step may begin at any instant.
  bool begins_anywhere = false;
  /// The body ends, as a layer does: its base adds a smooth kernel to the response, in which pressures that are uniform
  /// over each ring leave an error of second order.
  bool ends = false;
  /// A layer that slides on its base is stretched like a sheet, whose free side lets through the second power of its
  /// distance from the axis; fields of other bodies die out faster.
  bool stretches = false;
};

/// What has to be computed besides a resolution to measure its errors, each source by its own refinement, and what
/// reading the edges costs by the same rings with the edges elsewhere in them, and what happens within a step, as a
/// ring that touches or begins to slide, by the same steps half a step later. Where the resolution is fine, each source
/// is measured at a resolution that is coarser in a respect which does not make it smaller: rings and edges with half
/// the steps (all where the indenter moves by them, or rings touch in any order), element order and grading with fewer
/// steps, time step and creep with half the rings, far field, start and cycles with both, and all but creep with fewer
/// cycles of a motion without a period. Two variants of one source follow each other, the coarser one last. On a given
/// mesh (Resolution::mesh_refinements) coarser rings are merged neighbours; the grading is measured by cells split into
/// four under the same rings; rings that begin elsewhere are made of halves of neighbouring rings; where fewer than 24
/// rings lie within the contact radius, finer rings, of cells split into four, are taken instead of coarser ones. A
/// given mesh has no far field.
std::vector<Variant> variants_of(const Resolution& resolution, const CaseNeeds& needs);

/// The variants of a resolution for the course of wear, which ends shaken down and reads no edges: in rings, element
/// order, far field, time step, and the jumps over many cycles. All but that in the rings are measured on half of the
/// rings, and of these all but that in the time step with half of the steps.
std::vector<Variant> variants_of_wear(const Resolution& resolution);

/// A resolution that is finer in one respect, rings and steps by a factor of 1.5 or 2; empty: it cannot be refined
/// further in this respect.
std::optional<Resolution> refined(const Resolution& resolution, ErrorSource source, double factor = 2);

}  // namespace fretval
