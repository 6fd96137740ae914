#include "comparison/accuracy/refinement_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fretval {
namespace {

constexpr std::array sources{ErrorSource::rings,   ErrorSource::angles,    ErrorSource::element_order,
                             ErrorSource::grading, ErrorSource::far_field, ErrorSource::time_step,
                             ErrorSource::start,   ErrorSource::creep,     ErrorSource::cycles};
constexpr double most_dofs = 1.2e6;     // beyond that a body takes more than ten gigabytes
constexpr double weight_of_excess = 2;  // worth twice the cost to come twice as close where nothing is enough

/// Refinements of one source at once: the factors of each, one after another.
const std::vector<std::vector<double>>& refinements_of(ErrorSource source) {
  static const std::vector<std::vector<double>> by_twos{{2}, {2, 2}}, fine{{1.5}, {2}, {2, 1.5}, {2, 2}};
  return source == ErrorSource::rings || source == ErrorSource::time_step ? fine : by_twos;
}

/// Part of a share that is left after a refinement of its source by a factor of two.
double left_over(ErrorSource source, const ErrorShare& share) {
  constexpr double usual_order = 2, best_order = 3;
  const double by_order = std::exp2(-std::min(share.order.value_or(usual_order), best_order));
  const bool rings = source == ErrorSource::rings;
  if (rings && (share.source == ErrorSource::edge || share.source == ErrorSource::element_order)) return 0.25;
  if (source == ErrorSource::time_step && share.source == ErrorSource::instants) return 0.5;
  if (source != share.source) return 1;
  switch (source) {
    case ErrorSource::element_order:
    case ErrorSource::grading:
      return 0.125;
    case ErrorSource::far_field:
      return 0.0625;
    case ErrorSource::start:
      return 0.25;
    case ErrorSource::creep:
      return 0.5;
    case ErrorSource::cycles:
      return 0.1;
    default:
      return by_order;
  }
}

/// Effort after a refinement of a source by a factor, as measured on equal rings.
Effort effort_after(ErrorSource source, const Effort& effort, unsigned degree, double factor) {
  Effort after = effort;
  const auto growth = [doublings = std::log2(factor)](double of_two) { return std::pow(of_two, doublings); };
  switch (source) {
    case ErrorSource::rings:
      after.n_dofs *= growth(1.85);
      after.n_rings *= factor;
      break;
    case ErrorSource::angles:
      after.n_dofs *= factor;
      after.n_angles *= factor;
      break;
    case ErrorSource::element_order:
      after.n_dofs *= growth(std::pow(1 + 1.0 / degree, 2));
      break;
    case ErrorSource::grading:
      after.n_dofs *= growth(1.8);
      break;
    case ErrorSource::far_field:
      after.n_dofs *= growth(1.05);
      break;
    case ErrorSource::time_step:
    case ErrorSource::creep:
      after.n_steps *= factor;
      break;
    default:
      after.n_steps *= growth(1.2);
  }
  return after;
}

/// The widest bar over its tolerance.
double excess_of(const std::vector<BarToMeet>& bars) {
  double excess = 0;
  for (const auto& [bar, tolerance] : bars) excess = std::max(excess, bar.total() / tolerance);
  return excess;
}

struct Candidate {
  Resolution resolution;
  std::vector<BarToMeet> bars;  ///< as they are expected
  Effort effort;
  double excess = excess_of(bars);

  [[nodiscard]] bool meets() const { return excess <= 1; }
  [[nodiscard]] double price() const {
    return expected_seconds(effort) * std::pow(std::max(excess, 1.0), weight_of_excess);
  }
};

bool better(const Candidate& a, const Candidate& b) {
  if (a.meets() != b.meets()) return a.meets();
  return a.price() < b.price();
}

/// Constraints of a plan.
struct Limits {
  FixedByCase fixed;
  double most_seconds;
};

std::optional<Candidate> refined(const Candidate& candidate, ErrorSource source, double factor, const Limits& limits) {
  const auto resolution = refined(candidate.resolution, source, factor);
  if (!resolution) return std::nullopt;
  auto bars = candidate.bars;
  for (auto& [bar, tolerance] : bars)
    for (auto& share : bar.shares) {
      const double left = left_over(source, share);
      if (left < 1) share.estimate *= std::pow(left, std::log2(factor));
    }
  const auto effort = effort_after(source, candidate.effort, candidate.resolution.degree, factor);
  if (effort.n_dofs > most_dofs || expected_seconds(effort) > limits.most_seconds) return std::nullopt;
  return Candidate{*resolution, bars, effort};
}

bool can_be_refined(ErrorSource source, const Candidate& candidate, const FixedByCase& fixed) {
  if (source == ErrorSource::angles && candidate.effort.n_angles == 0) return false;
  return !(fixed.rings && source == ErrorSource::rings) && !(fixed.steps && source == ErrorSource::time_step);
}

/// The best of a candidate and all that follow from it by refining the sources from a given one on.
Candidate best_from(const Candidate& candidate, std::size_t first, const Limits& limits) {
  Candidate best = candidate;
  if (candidate.meets() || first == sources.size()) return best;
  const auto consider = [&](const Candidate& next) {
    auto found = best_from(next, first + 1, limits);
    if (better(found, best)) best = std::move(found);
  };
  consider(candidate);
  if (!can_be_refined(sources[first], candidate, limits.fixed)) return best;
  for (const auto& factors : refinements_of(sources[first])) {
    std::optional<Candidate> next = candidate;
    for (auto factor = factors.begin(); next && factor != factors.end(); ++factor)
      next = refined(*next, sources[first], *factor, limits);
    if (next) consider(*next);
  }
  return best;
}

}  // namespace

double expected_seconds(const Effort& effort) {
  const auto& [n_dofs, n_rings, n_steps, n_angles] = effort;
  const double of_a_step =
      n_angles > 0 ? 2.7e-8 * std::pow(n_angles, 1.25) * n_rings * n_rings : 1e-5 * std::pow(n_rings / 48, 1.4);
  return 1e-5 * n_dofs + n_steps * of_a_step;
}

std::optional<Resolution> planned_refinement(const Resolution& resolution, const std::vector<BarToMeet>& bars,
                                             const Effort& effort, const FixedByCase& fixed, double most_times) {
  auto known = bars;
  for (auto& [bar, tolerance] : known)
    for (auto& share : bar.shares) share.estimate = std::min(share.estimate, most_tolerances * tolerance);
  const Candidate now{resolution, known, effort};
  if (now.meets()) return std::nullopt;
  const auto best = best_from(now, 0, {fixed, most_times * expected_seconds(effort)});
  if (best.resolution == resolution) return std::nullopt;
  return best.resolution;
}

}  // namespace fretval
