#include "fem/ring_contact/stick_zone/slip_decay.h"

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem {

namespace {

/// of: the slips of the innermost rings in a period.
template <class Measure>
std::vector<double> over_amplitude(const FrictionHistory& history, Eigen::Index n_inside, const Measure& of) {
  std::vector<double> measures;
  if (n_inside == 0 || !(history.amplitude > 0)) return measures;
  for (const auto& slip : history.slip_of_periods) measures.push_back(of(slip.head(n_inside)) / history.amplitude);
  return measures;
}

}  // namespace

std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside) {
  return over_amplitude(history, n_inside, [](const auto& slip) { return slip.maxCoeff(); });
}

std::vector<double> mean_slip_of_periods(const FrictionHistory& history, const Eigen::VectorXd& areas,
                                         Eigen::Index n_inside, double stick_radius, SlipBeyond beyond) {
  const auto rings = areas.head(n_inside);
  const double inside = rings.sum(), area = pi * stick_radius * stick_radius;
  double steps = 0;  // from the middle of the last ring to that of what lies beyond, in rings
  if (beyond == SlipBeyond::linear && n_inside > 1) {
    const double end = std::sqrt(inside / pi), ring = end - std::sqrt((inside - rings[n_inside - 1]) / pi);
    steps = (ring + stick_radius - end) / (2 * ring);
  }
  return over_amplitude(history, n_inside, [&](const auto& slip) {
    const double outermost = slip[n_inside - 1], growth = steps == 0 ? 0 : outermost - slip[n_inside - 2];
    return (rings.dot(slip) + (area - inside) * (outermost + steps * growth)) / area;
  });
}

std::optional<DecayFactor> decay_factor(const FrictionHistory& history, Eigen::Index n_inside, int n_ramp) {
  constexpr double roundoff = 1e-10;
  const auto slip = slip_decay(history, n_inside);
  if (history.jumped) return std::nullopt;
  auto last = slip.size();
  while (last > 0 && !(slip[last - 1] > roundoff)) --last;
  if (last < static_cast<std::size_t>(n_ramp) + 4) return std::nullopt;
  const double now = slip[last - 1] / slip[last - 2], before = slip[last - 2] / slip[last - 3];
  if (!(now < 1 && before < 1 && slip[last - 3] > 0)) return std::nullopt;
  const double root = std::sqrt(now);
  return DecayFactor{now, std::abs(now - before) * root / (1 - root)};
}

}  // namespace fretval::fem
