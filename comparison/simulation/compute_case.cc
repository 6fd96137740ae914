#include "comparison/simulation/compute_case.h"

#include "comparison/simulation/full_case.h"
#include "comparison/simulation/normal_part.h"
#include "comparison/simulation/zone_answer.h"
#include "comparison/support/stopwatch.h"
#include "fem/contact/gross_slip.h"

namespace fretval {
namespace {

ContactProblems problems_of(const ContactBody& body) {
  return {body.normal, body.tangential ? &*body.tangential : nullptr};
}

/// The friction beside the normal contact, or none where the indenter does not move tangentially.
fem::FrictionHistory friction_beside(const NormalRecord& record, const fem::NormalHistory& normal,
                                     const ContactProblems& problems, const FemCase& fem,
                                     const fem::HistoryControl& control) {
  if (!problems.tangential)
    return fem::friction_at_rest(problems.normal, fem.friction_coefficient, record.pressures, normal);
  fem::WatchedFriction friction(*problems.tangential, fem.relaxation, fem.friction_coefficient, fem.motion,
                                control.steps_per_cycle);
  const std::size_t n_beside = fem.motion.is_single_pass() ? 0 : record.pressures.size();
  for (std::size_t k = 1; k < n_beside; ++k)
    if (fem.kind == ContactKind::annuli)
      friction.step(record.pressures[k]);
    else
      friction.step(record.pressures[k], record.instant(k));
  return fem::friction_history(std::move(friction), normal, control);
}

FeAnswer answer_of_histories(const ContactProblems& problems, const FemCase& fem, BodyStore& bodies) {
  if (fem.kind == ContactKind::plane) {
    auto on_rings = fem;
    on_rings.kind = ContactKind::discs;
    const bool has_rings = !fem.motion.moves_across();
    return compute_full_contact(
        problems, fem, has_rings ? std::optional(answer_of_histories(problems, on_rings, bodies)) : std::nullopt,
        bodies);
  }
  auto normal = normal_part(problems, fem, bodies.normals);
  const auto& history = normal.record->history;
  Stopwatch watch;
  auto friction = friction_beside(*normal.record, history, problems, fem, control_of(fem));
  auto answer = fem.kind == ContactKind::annuli
                    ? read_zones(problems, fem, normal.profile, history, std::move(friction))
                    : read_answer(problems, fem, normal.profile, normal.contact_radius, history, std::move(friction));
  answer.seconds = {normal.record->seconds, watch.lap()};
  return answer;
}

FeAnswer answer_of(const fem::GrossSlip& slip, const FemCase& fem) {
  FeAnswer answer;
  answer.of_kind = GrossSlipStart{fem.first_row + slip.time / fem.units.angular_frequency, slip.amplitude};
  return answer;
}

FeAnswer computed_on_one_mesh(const FemCase& fem, bool keeps_body, BodyStore& bodies) {
  std::shared_ptr<const Body> whole;
  const auto body = find_or_make_body(fem.body, bodies, keeps_body ? &whole : nullptr);

  FeAnswer answer;
  try {
    answer = answer_of_histories(problems_of(*body), fem, bodies);
  } catch (const fem::GrossSlip& slip) {
    answer = answer_of(slip, fem);
  }
  keep_to(fem.motion_kind, answer);
  answer.body = body->summary;
  answer.whole_body = whole;
  return answer;
}

}  // namespace

FeAnswer compute_case(const FemCase& fem_case, const Resolution& resolution, BodyStore& bodies) {
  const FemCase fem = at_resolution(fem_case, resolution);
  auto answer = computed_on_one_mesh(fem, fem_case.keeps_body && resolution == fem_case.resolution, bodies);
  if (const auto elsewhere = half_a_ring_away(fem, answer)) {
    auto other = at_resolution(fem_case, *elsewhere);
    other.full.second_algorithm = false;  // it confirms the steps of the answer
    average(computed_on_one_mesh(other, false, bodies), answer);
  }
  return answer;
}

}  // namespace fretval
