#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "comparison/support/stopwatch.h"

namespace fretval {

/// What histories need of the body of a description on a generated mesh, if a store has all its harmonics: equal bit
/// for bit to contact_body(make_body(description)), but for what it cost. A harmonic serves bodies with and without
/// the other one. n_processes: that have made it together, whose operators differ by roundoff.
std::optional<ContactBody> kept_body(const BodyDescription& description, const RingEdges& edges,
                                     const OperatorStore& operators, int n_processes = 1);

/// Keeps all harmonics of the body that was made of a description on its generated mesh.
void keep_body(const BodyDescription& description, const Body& body, OperatorStore& operators);

/// What is kept of a body beside its compliances.
std::map<std::string, double> figures_of(const meshes::MeshQuality& quality, const fem::HarmonicSpace& space);

/// The harmonics that a body needs, the normal one first.
std::vector<fem::FourierOrder> harmonics_of(const BodyDescription& description);

/// The body of the operators of its harmonics, in that order. The time on the watch is its cost, as that of reading
/// where they come from a store, of the factorisation otherwise.
ContactBody body_of(std::vector<fem::StoredOperator> harmonics, const RingEdges& edges, bool from_store,
                    Stopwatch& watch);

}  // namespace fretval
