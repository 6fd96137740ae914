#include "comparison/verdict.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

Difference judge(double difference, double tolerance) {
  return {difference, tolerance, std::abs(difference) <= tolerance};
}

Difference judge_stick(const std::optional<double>& fe, const std::optional<double>& mdr, double contact_radius,
                       double tolerance) {
  if (!mdr) return {std::nullopt, tolerance, !fe};
  const double ratio = *mdr / contact_radius;
  const double widened = tolerance * std::max(1.0, 0.1 / ratio);
  // A stick zone too small for the mesh is within a widened tolerance that covers all of it, or else a disagreement.
  if (!fe) return {std::nullopt, widened, ratio <= widened};
  return judge((*fe - *mdr) / contact_radius, widened);
}

}  // namespace

Tolerances tolerances_of(double accuracy) {
  return {accuracy, accuracy / 10, accuracy / 10};
}

Verdict compare(const MdrAnswer& mdr, const FeAnswer& fe, double unworn_radius, const Tolerances& tolerances) {
  Verdict verdict;
  if (fe.contact_radius_max)
    verdict["contact_radius_max"] =
        judge(*fe.contact_radius_max / mdr.contact_radius_max.value() - 1, tolerances.contact_radius);
  verdict["normal_force_max"] = judge(fe.normal_force_max / mdr.normal_force_max.value() - 1, tolerances.normal_force);
  const double tolerance = tolerances.stick_radius;
  verdict["stick_radius_first_slip"] =
      judge_stick(fe.stick_radius_first_slip, mdr.stick_radius_first_slip, unworn_radius, tolerance);
  verdict["stick_radius_shakedown"] =
      judge_stick(fe.stick_radius_shakedown, mdr.stick_radius_shakedown, unworn_radius, tolerance);
  if (fe.no_wear) {
    verdict["slip_inside_stick_zone"] = judge(fe.no_wear->slip_inside, tolerance);
    verdict["force_outside_stick_zone"] = judge(fe.no_wear->force_outside, tolerance);
    verdict["maximum_indentation"] = judge(fe.no_wear->touch_indentation - 1, tolerance);
  }
  return verdict;
}

bool passes(const Verdict& verdict) {
  return std::all_of(verdict.begin(), verdict.end(), [](const auto& entry) { return entry.second.pass; });
}

}  // namespace fretval
