#include "comparison/error_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval {
namespace {

double expected_order(ErrorSource source, const std::string& quantity, const SceneNeeds& needs) {
  if (source == ErrorSource::time_step || source == ErrorSource::start) return 2;
  if (source == ErrorSource::creep) return 1;
  if (source == ErrorSource::far_field) return 4;
  if (source == ErrorSource::rings && quantity == "normal_force_max" && needs.memory) return 2;
  const bool radius_or_force = quantity.find("radius") != std::string::npos || quantity == "normal_force_max";
  return source == ErrorSource::rings && !radius_or_force ? 1 : 3;
}

/// A quantity that only one of two computations has, differs by all it can.
double value_of(const Measures& measures, const std::string& quantity) {
  const auto found = measures.find(quantity);
  return found == measures.end() ? std::numeric_limits<double>::infinity() : found->second;
}

double element_error(double difference, unsigned degree) {
  if (degree == 2) return 1.25 * difference;
  return 3 * std::pow(difference, static_cast<double>(degree) / (degree - 1));
}

}  // namespace

double ErrorBar::total() const {
  double sum = 0;
  for (const auto& share : shares) sum += share.estimate;
  return sum;
}

const ErrorShare* ErrorBar::largest() const {
  const auto found = std::max_element(shares.begin(), shares.end(),
                                      [](const auto& a, const auto& b) { return a.estimate < b.estimate; });
  return found == shares.end() ? nullptr : &*found;
}

ErrorShare richardson(ErrorSource source, const Refinements& values, double expected_order) {
  const double fine = values.fine - values.medium;
  if (!values.coarse) return {source, 3 * std::abs(fine) / (std::exp2(expected_order) - 1), std::nullopt};
  const double coarse = values.medium - *values.coarse;
  const double order = std::log2(coarse / fine);
  if (fine * coarse > 0 && order >= expected_order / 2 && order <= 2 * expected_order)
    return {source, 1.25 * std::abs(fine) / (std::exp2(std::min(order, expected_order)) - 1), order};
  return {source,
          3 * std::max(std::abs(fine) / (std::exp2(expected_order) - 1),
                       std::abs(*values.coarse - values.fine) / (std::exp2(2 * expected_order) - 1)),
          std::nullopt};
}

ErrorBudget error_budget(const Measures& measures, const std::vector<Variant>& variants,
                         const std::vector<Measures>& varied, unsigned degree, const Measures& edge,
                         const SceneNeeds& needs) {
  ErrorBudget budget;
  for (const auto& [quantity, value] : measures) {
    auto& shares = budget[quantity].shares;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const auto source = variants[i].source;
      if (i > 0 && variants[i - 1].source == source) continue;  // the coarser one of two
      const double other = value_of(varied[i], quantity), difference = std::abs(value - other);
      if (source == ErrorSource::element_order) {
        shares.push_back({source, element_error(difference, degree), std::nullopt});
      } else if (source == ErrorSource::cycles || source == ErrorSource::active_set) {
        shares.push_back({source, difference, std::nullopt});
      } else {
        Refinements values{value, other, std::nullopt};
        if (i + 1 < variants.size() && variants[i + 1].source == source)
          values.coarse = value_of(varied[i + 1], quantity);
        shares.push_back(richardson(source, values, expected_order(source, quantity, needs)));
      }
    }
    const auto reading = edge.find(quantity);
    if (reading != edge.end()) shares.push_back({ErrorSource::edge, reading->second, std::nullopt});
  }
  return budget;
}

}  // namespace fretval
