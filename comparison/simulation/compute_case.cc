#include "comparison/simulation/compute_case.h"

#include "comparison/simulation/zone_answer.h"
#include "comparison/support/stopwatch.h"
#include "fem/contact/gross_slip.h"
#include "fem/contact/static_contact.h"

namespace fretval {
namespace {

/// The contact problems of a body at the slack of its active sets that is asked for.
class ProblemsAtSlack {
 public:
  ProblemsAtSlack(const ContactBody& body, double slack) : body_(body) {
    if (slack == Resolution{}.active_set_slack) return;
    normal_.emplace(body.normal, slack);
    if (body.tangential) tangential_.emplace(*body.tangential, slack);
  }

  [[nodiscard]] ContactProblems problems() const {
    if (normal_) return {*normal_, tangential_ ? &*tangential_ : nullptr};
    return {body_.normal, body_.tangential ? &*body_.tangential : nullptr};
  }

 private:
  const ContactBody& body_;
  std::optional<fem::ContactProblem> normal_, tangential_;
};

/// The friction beside the normal contact, or none where the indenter does not move tangentially. normal: with its
/// edges read.
fem::FrictionHistory friction_beside(const NormalRecord& record, const fem::NormalHistory& normal,
                                     const ContactProblems& problems, const FemCase& fem,
                                     const fem::HistoryControl& control) {
  if (!problems.tangential)
    return fem::friction_at_rest(problems.normal, fem.friction_coefficient, record.pressures, normal);
  fem::WatchedFriction friction(*problems.tangential, fem.relaxation, fem.friction_coefficient, fem.motion,
                                control.steps_per_cycle);
  const std::size_t n_beside = fem.motion.is_single_pass() ? 0 : record.pressures.size();
  for (std::size_t k = 1; k < n_beside; ++k)
    if (fem.any_order)
      friction.step(record.pressures[k]);
    else
      friction.step(record.pressures[k],
                    fem::NormalInstant{problems.normal.series.radii(), record.radii[k], record.forces[k]});
  return fem::friction_history(std::move(friction), normal, control);
}

fem::HistoryControl control_of(const FemCase& fem) {
  constexpr int most_cycles = 800;
  const int most_after_ramp = fem.without_short_cycle && fem.motion.locked ? fem::most_long_periods : most_cycles;
  return {fem.steps_per_cycle(), fem.motion.cycles_of_ramp() + most_after_ramp, fem.resolution.periodicity};
}

FeAnswer answer_of_histories(const ContactProblems& problems, const FemCase& fem, NormalStore& normals) {
  const auto profile = fem::ring_means(problems.normal.compliance, fem.profile);
  const auto control = control_of(fem);
  const auto record = normals.find_or_make(fem, problems.normal, profile, control);
  auto normal = record->history;
  Stopwatch watch;
  const auto contact_radius = fem.any_order ? std::nullopt : read_contact_radius(problems.normal, fem, profile, normal);
  auto friction = friction_beside(*record, normal, problems, fem, control);

  auto answer = fem.any_order
                    ? read_zones(problems, fem, profile, std::move(normal), std::move(friction))
                    : read_answer(problems, fem, profile, contact_radius, std::move(normal), std::move(friction));
  answer.seconds = {record->seconds, watch.lap()};
  return answer;
}

FeAnswer answer_of(const fem::GrossSlip& slip, const FemCase& fem) {
  FeAnswer answer;
  answer.gross_slip = GrossSlipStart{fem.first_row + slip.time / fem.units.angular_frequency, slip.amplitude};
  return answer;
}

}  // namespace

FeAnswer compute_case(const FemCase& fem_case, const Resolution& resolution, BodyStore& bodies) {
  const FemCase fem = at_resolution(fem_case, resolution);
  std::shared_ptr<const Body> whole;
  const bool keeps = fem_case.keeps_body && resolution == fem_case.resolution;
  const auto body = find_or_make_body(fem.body, bodies, keeps ? &whole : nullptr);
  const ProblemsAtSlack at_slack(*body, resolution.active_set_slack);

  FeAnswer answer;
  try {
    answer = answer_of_histories(at_slack.problems(), fem, bodies.normals);
  } catch (const fem::GrossSlip& slip) {
    answer = answer_of(slip, fem);
  }
  answer.body = body->summary;
  answer.whole_body = whole;
  return answer;
}

}  // namespace fretval
