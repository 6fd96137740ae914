#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/results/batch.h"

namespace fretval {

/// One quantity of a case at a tolerance, in the units of comparison (see Measures).
struct TrueError {
  double error;  ///< finite elements less the exact answer
  double tolerance, bar;

  [[nodiscard]] bool meets() const { return std::abs(error) <= tolerance; }
  [[nodiscard]] bool covered() const { return std::abs(error) <= bar; }
  [[nodiscard]] Verdict finding() const { return verdict_on(error, tolerance, bar); }
};

/// The cheapest setting of the grid whose true errors meet a tolerance.
struct Cheapest {
  Resolution resolution;
  double seconds;
};

using TrueErrors = std::map<std::string, TrueError>;

/// The cheapest settings that the proof covers, see CheapestProved.
struct Economised {
  std::vector<Resolution> resolutions;
  TrueErrors errors;
  double seconds = 0;  ///< of all of them alone, measured with the grid; 0 if it was not searched
};

/// A case at a tolerance.
struct ToleranceRecord {
  std::string name;
  double tolerance;
  std::string failure;  ///< not empty: the numerics failed
  TrueErrors errors;    ///< of the proved answer
  Resolution resolution;
  std::map<std::string, Focus> focus;
  int n_refinements = 0, n_probes = 0;
  double seconds = 0;  ///< see StudyResult
  ErrorBudget budget;
  Economised economised;

  bool in_grid = false;              ///< whether the grid was searched for this case
  std::optional<Cheapest> cheapest;  ///< empty: no setting of the grid meets the tolerance

  /// Of the proved answer and of the economised one.
  [[nodiscard]] bool meets() const;
  [[nodiscard]] bool covered() const;
  [[nodiscard]] bool inconclusive() const;
  [[nodiscard]] bool passes() const { return failure.empty() && meets() && covered(); }
};

/// A body whose cost is the median of three if it is so small that a single measurement is mostly noise.
Body make_timed_body(const BodySpecification& specification);

/// What MDR says about each case.
std::vector<MdrAnswer> exact_answers(const std::vector<PreparedCase>& cases);

/// Runs each case by a study of its own, all together and down to the cheapest settings that its proof covers, and
/// holds it against MDR: which is exact here, so that errors and the coverage by error bars can be told apart.
std::vector<ToleranceRecord> tolerance_records(const std::vector<PreparedCase>& cases,
                                               const std::vector<MdrAnswer>& exact);

struct ToleranceSuiteOptions {
  std::vector<double> tolerances{1e-2, 1e-3, 1e-4};
  bool costs = true;  ///< whether the grid of settings is searched for the cheapest ones
};

/// The suite: all cases at each tolerance, and the grid of settings for 15 of the cases.
std::vector<ToleranceRecord> run_tolerance_suite(const ToleranceSuiteOptions& options = {});

}  // namespace fretval
