#pragma once

#include <map>
#include <vector>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/prepared_case.h"

namespace fretval {

/// The resolutions that an answer is read from: one for all quantities but those stick radii that need rings graded to
/// their edge.
struct Tracks {
  Resolution base;
  std::map<Quantity, Resolution> focused;

  [[nodiscard]] std::vector<Resolution> all() const;
  [[nodiscard]] const Resolution& of(Quantity quantity) const;
};

/// Rings that resolve a stick zone, or the slip annulus around it, where it has too few of them. It is to be called
/// repeatedly until the zone is resolved or proved smaller than the finest ring, or, for a stick zone that does not
/// show, smaller than a quarter of the tolerance. Empty: no finer rings are needed. The case must not fix its rings.
std::optional<Focus> closer_look(Quantity quantity, const Tracks& tracks, const Computations& computed,
                                 const Tolerances& tolerances);

/// Focuses on a stick zone that is not resolved if its rings get finer by least_gain; returns whether it did.
bool focus_on(Quantity quantity, double least_gain, const PreparedCase& prepared, const Computations& computed,
              Tracks& tracks);

}  // namespace fretval
