#include "comparison/accuracy/rings_needed.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

/// How many times finer the whole mesh has to be.
double times_finer(const ErrorBar& bar, double tolerance) {
  constexpr double usual_order = 2, best_order = 3, least_left = 0.5, step = 1.05, most = 64;
  double of_rings = 0, of_cells = 0, order = usual_order;
  for (const auto& share : bar.shares) {
    if (share.source == ErrorSource::grading) of_cells += share.estimate;
    if (share.source != ErrorSource::rings && share.source != ErrorSource::edge) continue;
    of_rings += share.estimate;
    if (share.order) order = std::clamp(*share.order, 1.0, best_order);
  }
  if (!std::isfinite(of_rings + of_cells)) return 2;
  const double left = std::max(tolerance - (bar.total() - of_rings - of_cells), least_left * tolerance);
  double times = 1;
  while (times < most && of_rings / std::pow(times, order) + of_cells / times > left) times *= step;
  return times;
}

}  // namespace

std::optional<GivenRings> given_rings_of(const PreparedCase& prepared, const ProvedAnswer& answer) {
  if (!prepared.fem.given || answer.fe.as<GrossSlipStart>() || !answer.failure.empty()) return std::nullopt;
  GivenRings rings{static_cast<unsigned>(answer.fe.rings.contact), {}};
  double most = 1;
  for (const auto& [quantity, bar] : answer.budget) {
    const double tolerance = tolerance_of(prepared.tolerances, quantity);
    if (!is_refined_for(quantity, prepared.tolerances) || bar.total() <= tolerance) continue;
    most = std::max(most, times_finer(bar, tolerance));
  }
  if (most > 1) rings.needed = static_cast<unsigned>(std::ceil(most * rings.in_contact));
  return rings;
}

}  // namespace fretval
