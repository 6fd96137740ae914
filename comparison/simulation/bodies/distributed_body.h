#pragma once

#include <functional>
#include <string>

#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "fem/operators/stiffness.h"

namespace fretval {

/// How bodies that are too large for one process are made: by all processes together, when any of them asks.
struct Distribution {
  std::size_t from_dofs;  ///< least number of dofs, of both harmonics, from which bodies are made together
  int n_processes;
  /// Passes a description as text to operators_made_together() in all processes, and returns the answer of the first
  /// one.
  std::function<std::string(const std::string& description)> make_together;
};

/// The body of a description, from the store if as many processes have kept it before, otherwise made by all. kept:
/// null if there is no store. Throws fem::SolverError.
ContactBody distributed_body(const BodyDescription& description, const RingEdges& edges,
                             const Distribution& distribution, OperatorStore* kept);

/// A description as bytes, with all digits.
std::string text_of(const BodyDescription& body);

/// For all processes at the same time, one thread each: meshes the body, assembles and factorises its harmonics
/// together, one after the other. Returns on the first process the operators as bytes for distributed_body, or why the
/// numerics failed; elsewhere nothing.
std::string operators_made_together(const std::string& description, const fem::Share& share);

}  // namespace fretval
