#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/zone_bars.h"
#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/fe_answer.h"
#include "comparison/support/parallel.h"

namespace fretval {

/// How far an answer is proved: not at all; with error bars, whatever they are; until they meet the tolerance.
enum class Proof { none, bars, tolerance };
const char* name_of(Proof proof);

/// The answer of the finite elements to a case, as far as it is proved.
struct ProvedAnswer {
  FeAnswer fe;            ///< at the chosen resolution, with the stick radii of the focused ones; or gross slip
  std::string failure;    ///< of the numerics; not empty: there is no answer
  Resolution resolution;  ///< chosen
  std::map<Quantity, Focus> focus;           ///< stick radii that are read from a graded mesh
  ErrorBudget budget;                        ///< empty with Proof::none
  std::optional<ZoneBudget> zone_bars = {};  ///< bars of zones where rings touch in any order; empty without a proof
  int n_refinements = 0;
  ProofCost cost;      ///< of all computations
  double seconds = 0;  ///< of the processor, for the chosen resolutions without a proof
};

/// Computes a case and proves the answer, without a look at what MDR says:
///
/// 1. it begins with the coarsest resolution that is usually enough (resolution_for);
/// 2. a stick zone or a slip annulus of too few rings is focused on (closer_look); where the rings of the focus were
///    less than four times finer, step 4 gets there at a lower cost, unless the bar turns out to be more than 15
///    tolerances;
/// 3. the error budget, each source by its own refinement;
/// 4. while the bar of a quantity is wider than its tolerance, the sources are refined that are expected to bring it
///    within that at the lowest cost (planned_refinement). A refinement whose numerics fail is taken back.
///
/// Rings and steps that the case file fixes stay as they are. n_threads: of the computations of one step. Safe to call
/// from several threads with one store of bodies. told: see Computations.
ProvedAnswer prove(const PreparedCase& prepared, Proof proof, BodyStore& bodies, std::size_t n_threads = n_cores(),
                   const ComputationsDone& told = {});

/// Proves the answer to a case with another function that computes it.
ProvedAnswer prove(const PreparedCase& prepared, Proof proof, const Compute& compute, std::size_t n_threads = 1,
                   const ComputationsDone& told = {});

}  // namespace fretval
