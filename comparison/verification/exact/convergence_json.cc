#include "comparison/verification/exact/convergence_json.h"

#include "comparison/support/json.h"

namespace fretval {

using nlohmann::ordered_json;

ordered_json convergence_json(const std::vector<ConvergenceRow>& rows) {
  ordered_json array = ordered_json::array();
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
                     {"goal", or_null(row.demand.goal)},
                     {"goal_met", or_null(meets_goal(row))},
                     {"verdict", failure.empty() ? "pass" : failure},
                     {"note", row.demand.note}});
  }
  return array;
}

}  // namespace fretval
