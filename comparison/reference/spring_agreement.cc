#include "comparison/reference/spring_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

std::string radius_text(double over_a) {
  return over_a > 0 ? fmt::format("{:.4g} a", over_a) : "none";
}

}  // namespace

SpringAgreement spring_agreement(const mdr::SpringBed& bed, const mdr::SpringHistory& history,
                                 const mdr::Profile& profile, const ClosedForm& closed_form) {
  const Eigen::Index n = bed.position.size();
  const double a = bed.position[n - 1] + bed.width[n - 1] / 2, one_spring = bed.width[n - 1] / a;
  const auto over_a = [&](double depth) { return depth > 0 ? mdr::inverse_transform(profile, depth) / a : 0; };
  SpringAgreement agreement{};

  const double formula = closed_form.shakedown.value_or(0) / a, springs = over_a(history.depths.shakedown),
               settled = over_a(history.settling_depth);
  agreement.shakedown = springs - formula;
  for (Eigen::Index i = 0; i < n && bed.position[i] < formula * a - bed.width[i]; ++i)
    agreement.slip_inside = std::max(agreement.slip_inside, history.slip_amplitude[i] / history.largest_shift);
  if (std::abs(agreement.shakedown) > one_spring) {
    const auto difference =
        fmt::format("shakedown radius {} by the springs, {} by the closed formula (a: largest contact radius): ",
                    radius_text(springs), radius_text(formula));
    if (std::abs(settled - formula) <= one_spring)
      agreement.warnings.push_back(
          difference +
          fmt::format("after {} periods, when their tractions repeat, springs inside still slip by up to {:.1e} of the "
                      "tangential amplitude in a period; slip dies out slowly where the body is much stiffer in motion "
                      "than at rest and both motions are nearly in phase. Trust the closed formula: the springs' "
                      "margins lead to {} when they have settled",
                      history.n_periods, agreement.slip_inside, radius_text(settled)));
    else
      agreement.warnings.push_back(
          difference +
          fmt::format("springs inside slip by up to {:.1e} of the tangential amplitude in a period, which is no "
                      "settling. Trust neither before a case with finer steps or a slower motion tells why",
                      agreement.slip_inside));
  }
  if (closed_form.has_first_slip) {
    const double first = closed_form.first_slip.value_or(0) / a, found = over_a(history.depths.first_slip);
    agreement.first_slip = found - first;
    if (std::abs(*agreement.first_slip) > one_spring)
      agreement.warnings.push_back(
          fmt::format("first-slip radius {} by the springs, {} by the closed formula (a: largest contact radius): it "
                      "depends on the start, and the formula's is slow against all relaxation. Trust the formula for "
                      "such a start, the springs for theirs, a ramp of some periods",
                      radius_text(found), radius_text(first)));
  }
  return agreement;
}

}  // namespace fretval
