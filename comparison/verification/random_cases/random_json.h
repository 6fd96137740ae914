#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/verification/random_cases/random_summary.h"

namespace fretval {

/// An object with `summary` (pass, verdict, seed, cases, comparisons, failures, above_bar, drawn_again, seconds,
/// histories), `quantities` (an object a quantity: its SoakDistribution), `memory` (the growth and the samples, bytes)
/// and `worst`, an array with an object a case: number, scene, failure, quantity, mdr, fe, error, bar, share,
/// largest_share, and case_file, the text of a case file with it. Null: what there is none of.
nlohmann::ordered_json soak_json(const SoakRun& run, const SoakSummary& summary);

}  // namespace fretval
