#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "comparison/support/stopwatch.h"

namespace fretval {

/// The ContactBody of a description on a generated mesh, if a store has all its harmonics: equal bit for bit to
/// contact_body(make_body(description)), but for its cost. A harmonic serves bodies with and without the other one.
/// n_processes: number of processes that have made it together, as operators depend on it by roundoff.
std::optional<ContactBody> kept_body(const BodyDescription& description, const RingEdges& edges,
                                     const OperatorStore& operators, int n_processes = 1);

/// Keeps all harmonics of the body that was made of a description on its generated mesh.
void keep_body(const BodyDescription& description, const Body& body, OperatorStore& operators);

/// Numbers that are kept of a body beside its compliances.
std::map<std::string, double> figures_of(const meshes::MeshQuality& quality, const fem::HarmonicSpace& space);

/// The harmonics that a body needs, the normal one first.
std::vector<fem::FourierOrder> harmonics_of(const BodyDescription& description);

/// The body from the operators of its harmonics, in the order of harmonics_of(). The time on the watch is its cost: of
/// reading if they come from a store, otherwise of the factorisation.
ContactBody body_of(std::vector<fem::StoredOperator> harmonics, const RingEdges& edges, bool from_store,
                    Stopwatch& watch);

}  // namespace fretval
