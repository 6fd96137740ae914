#include "comparison/simulation/compute_case.h"

#include "comparison/support/stopwatch.h"
#include "fem/history/gross_slip.h"
#include "fem/history/static_contact.h"

namespace fretval {
namespace {

/// The contact problems of a body at the slack of its active sets that is asked for.
class ProblemsAtSlack {
 public:
  ProblemsAtSlack(const ContactBody& body, double slack) : body_(body) {
    if (slack == Resolution{}.active_set_slack) return;
    normal_.emplace(body.normal.compliance, slack);
    if (body.tangential) tangential_.emplace(body.tangential->compliance, slack);
  }

  [[nodiscard]] ContactProblems problems() const {
    if (normal_) return {*normal_, tangential_ ? &*tangential_ : nullptr};
    return {body_.normal, body_.tangential ? &*body_.tangential : nullptr};
  }

 private:
  const ContactBody& body_;
  std::optional<fem::ContactProblem> normal_, tangential_;
};

/// Friction beside the normal contact, or none where the indenter does not move tangentially.
class Friction {
 public:
  Friction(const ContactProblems& problems, const FemCase& fem, const fem::NormalContact& at_start) {
    if (problems.tangential)
      moved_.emplace(*problems.tangential, fem.relaxation, fem.friction_coefficient, fem.motion,
                     at_start.steps_per_cycle());
    else
      at_rest_.emplace(at_start, fem.friction_coefficient);
  }

  void step_beside(const fem::NormalContact& normal) {
    moved_ ? moved_->step_beside(normal) : at_rest_->step(normal.pressure);
  }

  [[nodiscard]] fem::FrictionHistory history(const fem::NormalHistory& normal, const fem::HistoryControl& control) {
    return moved_ ? fem::friction_history(std::move(*moved_), normal, control) : at_rest_->history(normal);
  }

 private:
  std::optional<fem::WatchedFriction> moved_;
  std::optional<fem::FrictionAtRest> at_rest_;
};

fem::HistoryControl control_of(const FemCase& fem) {
  constexpr int most_after_ramp = 800;
  return {fem.steps_per_cycle(), fem.motion.cycles_of_ramp() + most_after_ramp, fem.resolution.periodicity};
}

FeAnswer answer_of_histories(const ContactProblems& problems, const FemCase& fem) {
  Stopwatch watch;
  const auto profile = fem::ring_means(problems.normal.compliance, fem.profile);
  const auto control = control_of(fem);
  fem::NormalContact normal_contact(problems.normal, fem.relaxation, profile, fem.motion, control.steps_per_cycle);
  Friction friction_contact(problems, fem, normal_contact);
  auto normal = fem::normal_history(std::move(normal_contact), control,
                                    [&](const fem::NormalContact& contact) { friction_contact.step_beside(contact); });
  const double normal_seconds = watch.lap();
  const auto contact_radius = read_contact_radius(problems.normal, fem, profile, normal);
  auto friction = friction_contact.history(normal, control);

  auto answer = read_answer(problems, fem, profile, contact_radius, std::move(normal), std::move(friction));
  answer.seconds = {normal_seconds, watch.lap()};
  return answer;
}

FeAnswer answer_of(const fem::GrossSlip& slip, const FemCase& fem) {
  FeAnswer answer;
  answer.gross_slip = GrossSlipStart{slip.time / fem.units.angular_frequency, slip.amplitude};
  return answer;
}

}  // namespace

FeAnswer compute_case(const FemCase& fem_case, const Resolution& resolution, BodyStore& bodies) {
  const FemCase fem = at_resolution(fem_case, resolution);
  Stopwatch watch;

  std::shared_ptr<const Body> whole;
  const auto body = bodies.find_or_make(fem.body, [&] {
    const auto mesh = bodies.meshes.mesh_of(fem.body);
    const double mesh_seconds = watch.lap();
    auto operators = assemble_operators(mesh, bodies.meshes.name, fem.body.degree, fem.body.tangential);
    operators.cost.mesh = mesh_seconds;
    const auto made = std::make_shared<const Body>(condense(std::move(operators)));
    if (fem_case.keeps_body && resolution == fem_case.resolution) whole = made;
    return contact_body(*made);
  });
  const ProblemsAtSlack at_slack(*body, resolution.active_set_slack);

  FeAnswer answer;
  try {
    answer = answer_of_histories(at_slack.problems(), fem);
  } catch (const fem::GrossSlip& slip) {
    answer = answer_of(slip, fem);
  }
  answer.body = body->summary;
  answer.whole_body = whole;
  return answer;
}

}  // namespace fretval
