#include "mdr/springs/force_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mdr/springs/spring_energy.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

struct Line {
  double value, slope;
};

// Root of a function that does not fall and is made of lines, perhaps with jumps. Newton's method; where a jump or a
// flat line throws it out of the bracket, bisection, and where there is no bracket yet, steps that grow.
template <class Function>
double root_of_lines(const Function& line_at, double start, double reach) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double scale = std::max(std::abs(start), reach);
  double lower = -infinity, upper = infinity, x = start;
  const auto roundoff_at = [&](double root) {
    return std::numeric_limits<double>::epsilon() * std::max(scale, std::abs(root));
  };
  while (upper - lower > roundoff_at(x)) {
    const double roundoff = roundoff_at(x);
    const auto [value, slope] = line_at(x);
    (value < 0 ? lower : upper) = x;
    double next = slope > 0 ? x - value / slope : x;
    if (std::abs(next - x) <= roundoff && slope > 0) return next;
    if (!(next > lower && next < upper))
      next = std::isinf(upper) ? lower + (reach *= 2) : std::isinf(lower) ? upper - (reach *= 2) : (lower + upper) / 2;
    x = next;
  }
  return (lower + upper) / 2;
}

// Position of the indenter if it moves on as in the last step.
double moving_on(double last, double before) {
  return 2 * last - before;
}

}  // namespace

double indentation_for_load(const SpringStep& step, const SpringState& state, const SpringBed& bed, double load) {
  require_positive("normal load", load);
  const NormalLines lines = step.normal_lines(state, bed);
  const auto excess = [&](double d) -> Line {
    const auto touching = (d > lines.touch).cast<double>() * bed.width;  // evaluated where it is summed
    return {lines.slope * (touching * (d - lines.zero)).sum() - load, lines.slope * touching.sum()};
  };
  return root_of_lines(excess, moving_on(state.indenter.indentation, state.indenter_before.indentation),
                       std::max(bed.depth.abs().maxCoeff(), std::abs(state.indenter.indentation)));
}

double tangential_for_load(const SpringStep& step, const SpringState& state, const SpringBed& bed, double indentation,
                           double load) {
  require_finite("tangential load", load);
  const TangentialLines lines = step.tangential_lines(state, bed, indentation);
  const double most = (bed.width * lines.most).sum();
  if (std::abs(load) >= most) {
    GrossSlip slip("tangential force of " + std::to_string(std::abs(load) / most) +
                   " times mu times the normal force: the contact slides, there is no displacement for it");
    slip.excess = std::abs(load) - most;
    throw slip;
  }
  const auto excess = [&](double shift) -> Line {
    const auto stuck = lines.value + shift * lines.slope;  // evaluated where they are summed
    const auto sticks = (stuck.abs() < lines.most).cast<double>() * bed.width;
    return {(bed.width * stuck.min(lines.most).max(-lines.most)).sum() - load, (sticks * lines.slope).sum()};
  };
  const double last = state.indenter.tangential;
  return last + root_of_lines(excess, moving_on(last, state.indenter_before.tangential) - last, most / bed.width.sum());
}

IndenterState balanced(const SpringStep& step, const SpringState& state, const SpringBed& bed,
                       const PrescribedInStep& prescribed) {
  IndenterState to = prescribed.indenter;
  if (prescribed.normal_load) {
    to.indentation = indentation_for_load(step, state, bed, *prescribed.normal_load);
    to.indentation_rate = step.arrived(state, to.indentation, to.tangential).indentation_rate;
  }
  if (prescribed.tangential_load) {
    to.tangential = tangential_for_load(step, state, bed, to.indentation, *prescribed.tangential_load);
    to.tangential_rate = step.arrived(state, to.indentation, to.tangential).tangential_rate;
  }
  return to;
}

double relaxed_indentation(const SpringBed& bed, const PronyBody& body, double force) {
  const PronyBody relaxed = elastic(body.relaxed_modulus);
  return indentation_for_load(SpringStep(relaxed, 1, 1), relaxed_state(bed, relaxed, 0), bed,
                              force / normal_scale(body));
}

}  // namespace fretval::mdr
