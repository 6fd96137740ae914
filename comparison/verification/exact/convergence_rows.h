#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fretval {

/// Demands on a row. Errors are relative.
struct ConvergenceDemand {
  double tolerance;       ///< at the goal's resolution and finer ones
  double expected_order;  ///< 0: none, the scheme is exact but for the floor
  double floor;           ///< smaller errors have another source than the resolution, which the note names
  const char* note;       ///< source of the floor
  int goal_resolution = 64;
};

/// Errors of one quantity against its exact solution on nested resolutions.
struct ConvergenceRow {
  std::string solution, quantity;
  std::string source;  ///< of the exact solution
  ConvergenceDemand demand;
  std::string refined = "rings";      ///< what the resolutions count: rings per contact radius, steps
  std::vector<int> resolutions = {};  ///< rising
  std::vector<double> errors = {};    ///< per resolution, the largest over the positions of an edge within its ring
};

/// Order of convergence: least-squares slope of -log(error) over log(resolution), of the errors above the floor. Empty
/// with fewer than two such errors, or if one is not finite.
std::optional<double> observed_order(const ConvergenceRow& row);

/// How far the observed order may stay below the expected one: the positions of an edge within its ring differ from
/// mesh to mesh.
constexpr double order_slack = 0.3;

/// Why a row fails; empty: it passes. It passes when all errors are finite, those at the goal's resolution and finer
/// ones are within the tolerance, and the observed order, if any error is above the floor, is the expected one.
std::string failure_of(const ConvergenceRow& row);

/// JUnit XML of the rows.
std::string convergence_junit(const std::vector<ConvergenceRow>& rows);

/// An array with an object for each row: solution, quantity, source, refined, resolutions, errors, observed_order,
/// expected_order, tolerance, verdict ("pass" or why it fails), note. Null: observed_order with all errors at the
/// floor, and errors that are not finite.
nlohmann::ordered_json convergence_json(const std::vector<ConvergenceRow>& rows);

}  // namespace fretval
