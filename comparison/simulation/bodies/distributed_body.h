#pragma once

#include <functional>
#include <string>

#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "fem/operators/stiffness.h"

namespace fretval {

/// How bodies are made that are too large for one process: by all of them together, on demand of any.
struct Distribution {
  std::size_t from_dofs;  ///< bodies with so many, both harmonics, or more
  int n_processes;
  /// Gives a description as text to operators_made_together in all processes, and the answer of the first one back.
  std::function<std::string(const std::string& description)> make_together;
};

/// The body, from the store if these processes have kept it before, or made by all. kept: null, no store. Throws
/// fem::SolverError.
ContactBody distributed_body(const BodyDescription& description, const RingEdges& edges,
                             const Distribution& distribution, OperatorStore* kept);

/// A description as bytes, with all digits.
std::string text_of(const BodyDescription& body);

/// For all processes at the same time, one thread each: meshes the body, assembles and factorises its harmonics
/// together, one after the other. Returns on the first process the operators as bytes for distributed_body, or why the
/// numerics failed; elsewhere nothing.
std::string operators_made_together(const std::string& description, const fem::Share& share);

}  // namespace fretval
