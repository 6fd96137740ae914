#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "comparison/accuracy/refinement.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// Error of one quantity from one source.
struct ErrorShare {
  ErrorSource source;
  double estimate;
  std::optional<double> order;  ///< observed, where it is credible
};

/// Error bar of one quantity: the shares add up, whatever their signs.
struct ErrorBar {
  std::vector<ErrorShare> shares;  ///< one a source
  /// To the share of that source, or as one.
  void add(ErrorSource source, double estimate);
  [[nodiscard]] double total() const;
  /// Without what the data leave open, which is the same for both methods: what a comparison of them depends on.
  [[nodiscard]] double of_numerics() const;
  /// Null if there are no shares.
  [[nodiscard]] const ErrorShare* largest() const;
};

/// For the log: "error bar of ... is 2.0e-03 (rings 1.9e-03), 1.0e-03 is asked for", with the shares of a tenth or
/// more.
std::string excess_text(Quantity quantity, const ErrorBar& bar, double tolerance);

using ErrorBudget = std::map<Quantity, ErrorBar>;

/// Measured values of a quantity at a resolution that was coarsened by 2, and by 4 (if there is one).
struct Refinements {
  double fine, medium;
  std::optional<double> coarse;
  double medium_reading = 0, coarse_reading = 0;  ///< by which reading them may be off
};

/// Richardson's estimate of the error of the finest value, as in Roache's grid convergence index (1994): with the
/// observed order p if the differences have the same sign and p is credible, at least half of the expected order,
/// 1.5 |fine - medium| / (2^min(p, expected) - 1); with Roache's 1.25 two of 400 errors were 1.06 and 1.15 bars.
/// Otherwise with the expected order and three times the larger of what the two differences imply: one of them alone
/// may be small by chance. Or, if that is less, of the coarse difference without what its reading leaves open (a zone
/// of two rings may be read by a tenth of its radius off, and says nothing of the finest one then), and of the medium
/// one with all that chance may hide of it, which is what its reading leaves open.
ErrorShare richardson(ErrorSource source, const Refinements& values, const ExpectedOrder& expected);

/// The budget of the quantities at a resolution. known: the quantities there and at each of its variants_of (empty if
/// the numerics failed), with their references; edge: the uncertainty of reading the edges (fem::EdgeRadius), by
/// quantity. That of the contact radius lies between the time steps, and counts there. readings: the same at variants,
/// as far as they are known.
///
/// Rings: third order, second where they are graded to a worn edge (-4.1e-4, -2.0e-4, -4.3e-5, -9.9e-6 at 16 to 128
/// rings), first for what the worn edge lets through, in a ring that shrinks with the square. With memory the force
/// counts as second order, up to sixth is credible as for all that is of third: the pressure next to the edge depends
/// on when its ring touched, and coarser rings do not show all of that. The tangential amplitude under a force is of
/// second order: readings of the force that reverse with few rings scatter (2.3e-4, 1.7e-4, 1.1e-5, 3.0e-5 at 32, 48,
/// 96, 192 rings). Time step, start and jumps of wear: second, but for friction with rings that are held from the start
/// of their step, and for the decay of slip, which takes place in one step: first; where rings touch in any order
/// (ContactKind::annuli) all that depends on the rings counts as first, up to fourth is credible; creep: first
/// (2.3e-4, 1.15e-4, 4.6e-5 at 24, 48, 96 cycles); far field: fourth (4.5 to 5 measured); grading: at least third, of a
/// given mesh, whose cells are split, first. Elements: functionals converge like q^(2k) in the degree k, so the
/// difference D from degree j < k stands for an error of D^(k/j), times 3; at degree 2, whose check is degree 3, for D
/// itself, times 1.25. Cycles and active set: the difference made by ten times the periodicity or the slack.
ErrorBudget error_budget(const Resolution& resolution, const std::map<Resolution, Quantities>& known,
                         const Quantities& edge, const CaseNeeds& needs = CaseNeeds(),
                         const std::map<Resolution, Quantities>& readings = {});

/// By how much a quantity changes from the second resolution to the first; NaN where one of them does not have it.
using ChangeOnRefinement = std::function<double(const Resolution& finer, const Resolution& coarser)>;

/// The shares of a quantity by its differences, which may also be distances between fields: then the bar is one of the
/// distance to the true field.
ErrorBar error_bar(Quantity quantity, const std::vector<Variant>& variants, const ChangeOnRefinement& change,
                   const CaseNeeds& needs, const std::map<Resolution, Quantities>& readings = {});

/// The same with other variants: known at each of them and its reference.
ErrorBudget error_budget(const Resolution& resolution, const std::vector<Variant>& variants,
                         const std::map<Resolution, Quantities>& known, const Quantities& edge, const CaseNeeds& needs,
                         const std::map<Resolution, Quantities>& readings = {});

}  // namespace fretval
