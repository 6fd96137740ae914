#pragma once

#include <optional>
#include <vector>

#include "comparison/simulation/fem_case/fem_case.h"

namespace fretval {

/// Where an error comes from. That of the data is none of the numerics: both methods share it.
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
  data
};
const char* name_of(ErrorSource source);

/// A resolution that differs from a reference in one respect: coarser, or finer where coarser does not exist.
struct Variant {
  ErrorSource source;
  Resolution resolution, reference;
};

/// What must not be refined because the case file fixes it.
struct FixedByCase {
  bool rings, steps;
};

/// What the errors of a case depend on: an elastic body has no memory of its start, a single pass starts as it does, a
/// locked phase does not creep, the rings of a worn profile are graded, and rings that touch are held from the start of
/// their step on with a dashpot or under a tangential force (see fem::FrictionContact), or where rings touch in any
/// order; there zones end with rings, and what is read of them is of first order. So is a stick radius next to the edge
/// of the smallest contact, whose last rings are loaded or free as a whole (1.5e-4, 8e-5, 4e-5, 2e-5 of a contact
/// radius at 16 to 128 rings).
struct CaseNeeds {
  explicit CaseNeeds() = default;  // no list of values without their names
  bool memory = true, creep = false, held_from_start = false;
  ContactKind kind = ContactKind::discs;
  MotionKind motion_kind = MotionKind::cycles;
  bool first_slip_ends_with_contact = false, shakedown_ends_with_contact = false;
  /// A branch relaxes within two steps: what coarser ones seem to say of an order in the step is not believed.
  bool has_short_branch = false;
  /// The indenter follows a tangential force or the rows of a path, step by step: errors of rings and steps depend on
  /// each other.
  bool moves_by_steps = false;
  /// Stick zones on rings and angles are read of their points alone, and no ring contact corrects the edges: that costs
  /// a quarter of a ring, which is of first order.
  bool zones_of_points = false;
  /// On a layer, or another body that ends, pressures uniform over each ring leave the second order of what its base
  /// adds to the response, a smooth kernel.
  bool ends = false;
  /// A layer that slides on its base is stretched like a sheet, whose free side lets through the second power of its
  /// distance from the axis; fields of other bodies die out faster.
  bool stretches = false;
};

/// What has to be computed besides a resolution to measure its errors, each source by its own refinement, and what
/// reading the edges costs by the same rings with the edges elsewhere in them. Where the resolution is fine, each
/// source is measured on something coarser that it does not get smaller by: rings and edges with half the steps (all
/// where the indenter moves by them, or rings touch in any order), element order and grading with fewer steps, time
/// step and creep with half the rings, far field, start and cycles with both. Two of one source follow each other, the
/// coarser one last. Of a given mesh (Resolution::mesh_refinements) coarser rings are neighbours together, the grading
/// is that of cells split into four, with the same rings, and rings that begin elsewhere are halves of them, each with
/// that of the next; where it has fewer than 24
/// within the contact radius, finer ones are those of cells split into four. It has no far field.
std::vector<Variant> variants_of(const Resolution& resolution, const CaseNeeds& needs);

/// The same for the course of wear, which ends shaken down and reads no edges: rings, element order, far field, time
/// step, and the jumps over many cycles; all but the rings on half of them, and all but those two with half the steps.
std::vector<Variant> variants_of_wear(const Resolution& resolution);

/// A resolution that is finer in one respect, rings and steps by a factor of 1.5 or 2; empty: it cannot be refined
/// further in this respect.
std::optional<Resolution> refined(const Resolution& resolution, ErrorSource source, double factor = 2);

}  // namespace fretval
