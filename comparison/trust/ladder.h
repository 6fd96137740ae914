#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/proof.h"
#include "comparison/quantities/plane_edges.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// A case over a body for which some of MDR's assumptions are dropped.
struct Rung {
  std::string key;    ///< in JSON: "body", "poisson_ratio", "friction", "coupling", "whole"
  std::string title;  ///< "a layer 2 mm thick", "nu = 0.45", "friction as a vector"
  Case input;
};

/// From MDR's own model, an incompressible half-space with a traction along x: one rung for each of its assumptions
/// that the case does not keep. No contact keeps the direction of the traction, whatever the case file says of it;
/// friction is a vector on a rung wherever the full contact computes the motion.
std::vector<Rung> rungs_of(const Case& input);

/// All assumptions of MDR dropped but the one that pressure and friction are not coupled.
Case case_without_coupling(const Case& input);

/// The same with coupling; empty: over an incompressible half-space there is none, or friction is not computed as a
/// vector.
std::optional<Case> coupled_case(const Case& input);

/// MDR's own model of a case.
Case case_for_mdr(const Case& input);

/// By how much MDR's own model is off.
struct OffBy {
  Reading fe;              ///< what finite elements say, with their error bar
  double value = 0;        ///< MDR's value over that, less 1
  double uncertainty = 0;  ///< of the value, by both methods

  /// Whether it is more than numerics.
  [[nodiscard]] bool is_resolved() const;
  /// What finite elements say over MDR's value, less 1.
  [[nodiscard]] double change() const;
};
using OffBys = std::map<Quantity, OffBy>;

/// Of what is compared and both methods have a value for that is not 0, but for what settles and what slip has locked
/// in.
OffBys off_by(const Readings& mdr, const ProvedAnswer& fe, const Units& units);

struct RungAnswer {
  Rung rung;
  OffBys off_by;
};

/// An assumption that no rung drops, and of what order its effect is in this case.
struct NotComputed {
  std::string assumption, order;
};

/// How far MDR can be trusted in a case, and why.
struct Ladder {
  Readings mdr;                     ///< of its own model
  std::vector<RungAnswer> rungs;    ///< one assumption dropped each; coupling: beside all others, against all others
  RungAnswer whole;                 ///< all of them
  double contact_radius;            ///< m, of finite elements for the whole
  std::optional<PlaneEdges> edges;  ///< of zones, of the whole; empty: friction is not a vector there
  std::vector<NotComputed> not_computed;
};

/// Computes and proves each rung, to the tolerance of the case. Throws fem::SolverError where the numerics of one fail,
/// InputError for a case that cannot be compared or wears.
Ladder ladder_of(const Case& input, BodyStore& bodies);

/// What is not computed in a case whose largest contact radius is this, m.
std::vector<NotComputed> not_computed_in(const Case& input, double contact_radius);

}  // namespace fretval
