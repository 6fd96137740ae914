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
  std::optional<double> order;  ///< observed order of convergence, where it is credible
};

/// Error bar of one quantity: the shares add up, whatever their signs.
struct ErrorBar {
  std::vector<ErrorShare> shares;  ///< one for each source
  /// Adds to the share of a source, which is made if there is none.
  void add(ErrorSource source, double estimate);
  [[nodiscard]] double total() const;
  /// The total without the share of the data, which is the same for both methods: the bar for a comparison of them.
  [[nodiscard]] double of_numerics() const;
  /// The largest share; null if there are none.
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
  double medium_reading = 0, coarse_reading = 0;  ///< uncertainties of reading medium and coarse
};

/// Richardson's estimate of the error of the finest value, as in Roache's grid convergence index (1994): with the
/// observed order p if the differences have the same sign and p is credible, at least half of the expected order, 1.5
/// |fine - medium| / (2^min(p, expected) - 1); with Roache's 1.25 two of 400 errors were 1.06 and 1.15 bars. Otherwise
/// with the expected order and three times the larger of what the two differences imply: one of them alone may be small
/// by chance. Where it gives less, the uncertainty of reading is taken into account instead: it is taken off the coarse
/// difference (a zone of two rings may be read by a tenth of its radius off, and says nothing of the finest value
/// then), and added to the medium one, in which chance may hide as much.
ErrorShare richardson(ErrorSource source, const Refinements& values, const ExpectedOrder& expected);

/// The budget of the quantities at a resolution. known: the quantities there and at each of its variants_of (empty if
/// the numerics failed), with their references; edge: the uncertainty of reading the edges (fem::EdgeRadius), by
/// quantity. That of the contact radius comes from the time steps, and is part of their share. readings: uncertainties
/// of reading the edges at variants, as far as they are known; infinite: the value there says nothing.
///
/// Rings: third order, second where they are graded to a worn edge (-4.1e-4, -2.0e-4, -4.3e-5, -9.9e-6 at 16 to 128
/// rings), first for what the worn edge lets through, in a ring that shrinks with the square. The tangential amplitude
/// under a force is of second order: readings of the force that reverse with few rings scatter (2.3e-4, 1.7e-4, 1.1e-5,
/// 3.0e-5 at 32, 48, 96, 192 rings). Time step, start and jumps of wear: second, but for friction with rings that are
/// held from the start of their step, and for the decay of slip, which takes place in one step: first; where rings
/// touch in any order (ContactKind::annuli) all that depends on the rings counts as first, up to fourth is credible, as
/// do stick zones on rings and angles (-1.694e-2, -1.708e-2, -1.721e-2 of c at 24, 48, 96 rings along x);
/// creep: first (2.3e-4, 1.15e-4, 4.6e-5 at 24, 48, 96 cycles); far field: fourth (4.5 to 5 measured); grading: at
/// least third, of a given mesh, whose cells are split, first. Elements: functionals converge like q^(2k) in the degree
/// k, so the difference D from degree j < k stands for an error of D^(k/j), times 3; at degree 2, whose check is degree
/// 3, for D itself, times 1.25. Cycles and active set: the difference made by ten times the periodicity or the slack.
ErrorBudget error_budget(const Resolution& resolution, const std::map<Resolution, Quantities>& known,
                         const Quantities& edge, const CaseNeeds& needs = CaseNeeds(),
                         const std::map<Resolution, Quantities>& readings = {});

/// Change of a quantity from the coarser resolution to the finer one; NaN where one of them does not have it.
using ChangeOnRefinement = std::function<double(const Resolution& finer, const Resolution& coarser)>;

/// The error bar of a quantity from its changes between resolutions. These may also be distances between fields: then
/// it is a bar of the distance to the true field.
ErrorBar error_bar(Quantity quantity, const std::vector<Variant>& variants, const ChangeOnRefinement& change,
                   const CaseNeeds& needs, const std::map<Resolution, Quantities>& readings = {});

/// The budget of the quantities at a resolution by variants of any kind. known: the quantities at each variant and at
/// its reference.
ErrorBudget error_budget(const Resolution& resolution, const std::vector<Variant>& variants,
                         const std::map<Resolution, Quantities>& known, const Quantities& edge, const CaseNeeds& needs,
                         const std::map<Resolution, Quantities>& readings = {});

}  // namespace fretval
