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

/// The rungs of a case. They start from MDR's own model, an incompressible half-space with a traction along x: one rung
/// for each assumption of it that the case does not keep. No contact keeps the direction of the traction, whatever the
/// case file says of it; friction is a vector on a rung wherever the full contact computes the motion.
std::vector<Rung> rungs_of(const Case& input);

/// The case with all of MDR's assumptions dropped, the coupling of pressure and friction included; empty: an
/// incompressible half-space does not couple them, or friction is not computed as a vector.
std::optional<Case> coupled_case(const Case& input);

/// MDR's own model of a case.
Case case_for_mdr(const Case& input);

/// Error of MDR's own model in a quantity.
struct OffBy {
  Reading fe;              ///< value by finite elements, with their error bar
  double value = 0;        ///< MDR's value over that, less 1
  double uncertainty = 0;  ///< of the value, by both methods

  /// Whether the error is larger than its uncertainty.
  [[nodiscard]] bool is_resolved() const;
};
using OffBys = std::map<Quantity, OffBy>;

/// Errors of MDR in the quantities that are compared and for which both methods have a value that is not 0; quantities
/// of settling and the mean tangential force are left out.
OffBys off_by(const Readings& mdr, const ProvedAnswer& fe, const Units& units);

struct RungAnswer {
  Rung rung;
  OffBys off_by;
};

/// An assumption that no rung drops, and the order of its effect in the case.
struct NotComputed {
  std::string assumption, order;
};

/// How far MDR can be trusted in a case, and why.
struct Ladder {
  Readings mdr;                     ///< readings of MDR's own model
  std::vector<RungAnswer> rungs;    ///< one assumption dropped in each; coupling: beside all others, against these
  RungAnswer whole;                 ///< all assumptions dropped
  double contact_radius;            ///< m, by finite elements, with all assumptions dropped
  std::optional<PlaneEdges> edges;  ///< of the zones, in `whole`; empty: friction is not a vector there
  std::vector<NotComputed> not_computed;
};

/// Computes and proves each rung, to the tolerance of the case. Throws fem::SolverError where the numerics of one fail,
/// InputError for a case that cannot be compared or wears.
Ladder ladder_of(const Case& input, BodyStore& bodies);

/// The assumptions that no rung drops. contact_radius: largest contact radius of the case, m.
std::vector<NotComputed> not_computed_in(const Case& input, double contact_radius);

}  // namespace fretval
