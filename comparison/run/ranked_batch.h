#pragma once

#include <exception>
#include <functional>
#include <vector>

#include "comparison/run/batch.h"
#include "comparison/support/ranks.h"

namespace fretval {

/// run_batch() on all ranks, which ask the first one for cases. Returns on the first rank the lines of all cases, equal
/// to those of run_batch() but for their seconds; on the others none. The work beside the cases is handed out in the
/// same way. All ranks call it, with the same cases, options and threads of their own; the folder of a case is written
/// by the rank that computes it, progress is called on the first one. bodies: the store of this rank. Bodies of
/// from_dofs dofs or more are made by all ranks together, while the cases go on.
///
/// give_up: called where a rank meets anything but failing numerics, by any thread; it has to end all ranks.
std::vector<BatchLine> run_ranked_batch(const std::vector<PreparedCase>& cases, const BatchOptions& options,
                                        BodyStore& bodies, const Ranks& ranks, std::size_t from_dofs,
                                        const std::function<void(const std::exception_ptr&)>& give_up);

}  // namespace fretval
