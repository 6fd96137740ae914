#pragma once

#include <optional>

#include "comparison/simulation/body.h"
#include "comparison/simulation/operator_store.h"

namespace fretval {

/// What histories need of the body of a specification on a generated mesh, if a store has all its harmonics: equal bit
/// for bit to contact_body(make_body(specification)), but for what it cost. A harmonic serves bodies with and without
/// the other one.
std::optional<ContactBody> kept_body(const BodySpecification& specification, const OperatorStore& operators);

/// Keeps all harmonics of the body that was made of a specification on its generated mesh.
void keep_body(const BodySpecification& specification, const Body& body, OperatorStore& operators);

}  // namespace fretval
