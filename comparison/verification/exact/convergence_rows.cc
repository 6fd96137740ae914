#include "comparison/verification/exact/convergence_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/support/json.h"
#include "comparison/support/junit.h"
#include "comparison/support/statistics.h"

namespace fretval {
namespace {

std::string name_of(const ConvergenceRow& row) {
  return fmt::format("{}: {}", row.solution, row.quantity);
}

}  // namespace

std::optional<double> observed_order(const ConvergenceRow& row) {
  std::vector<double> resolutions, errors;
  for (std::size_t i = 0; i < row.errors.size(); ++i) {
    if (!std::isfinite(row.errors[i])) return std::nullopt;
    resolutions.push_back(row.resolutions[i]);
    errors.push_back(std::abs(row.errors[i]));
  }
  const auto fit = log_slope(resolutions, errors, row.demand.floor);
  return fit ? std::optional(-fit->slope) : std::nullopt;
}

std::string failure_of(const ConvergenceRow& row) {
  const auto& demand = row.demand;
  if (std::count(row.resolutions.begin(), row.resolutions.end(), demand.goal_resolution) == 0)
    return fmt::format("no error at {} {}", demand.goal_resolution, row.refined);
  for (std::size_t i = 0; i < row.errors.size(); ++i) {
    if (!std::isfinite(row.errors[i])) return fmt::format("error at {} {} not finite", row.resolutions[i], row.refined);
    if (row.resolutions[i] >= demand.goal_resolution && std::abs(row.errors[i]) > demand.tolerance)
      return fmt::format("error {:.1e} at {} {}, tolerance {:.1e}", row.errors[i], row.resolutions[i], row.refined,
                         demand.tolerance);
  }
  const auto order = observed_order(row);
  if (order && *order < demand.expected_order - order_slack)
    return fmt::format("order {:.2f}, expected {:g}", *order, demand.expected_order);
  return "";
}

std::string convergence_junit(const std::vector<ConvergenceRow>& rows) {
  std::vector<JUnitCase> cases;
  cases.reserve(rows.size());
  for (const auto& row : rows) cases.push_back({name_of(row), failure_of(row)});
  return junit_document("fretval check exact", cases);
}

nlohmann::ordered_json convergence_json(const std::vector<ConvergenceRow>& rows) {
  auto array = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    const std::string failure = failure_of(row);
    array.push_back({{"solution", row.solution},
                     {"quantity", row.quantity},
                     {"source", row.source},
                     {"refined", row.refined},
                     {"resolutions", row.resolutions},
                     {"errors", row.errors},
                     {"observed_order", or_null(observed_order(row))},
                     {"expected_order", row.demand.expected_order},
                     {"tolerance", row.demand.tolerance},
                     {"verdict", failure.empty() ? "pass" : failure},
                     {"note", row.demand.note}});
  }
  return array;
}

}  // namespace fretval
