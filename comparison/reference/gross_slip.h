#pragma once

#include <optional>

#include "comparison/reference/mdr_case.h"

namespace fretval {

/// The share of all amplitudes at which the steady motion begins to slide as a whole, where that is algebra: one
/// frequency, both forces prescribed, F_0 + dF cos(wt) and F_x cos(wt + phi). Friction carries no more where
///   lambda |F_x e^{i phi} ± mu dF| = mu F_0,
/// or, with an unlocked phase, of which the worst value comes, where lambda (F_x + mu dF) = mu F_0. This is the balance
/// of forces, and holds for any indenter and body. Below 1 the case slides. Empty: no such case, or nothing moves.
std::optional<double> steady_sliding_share(const MdrCase& mdr);

}  // namespace fretval
