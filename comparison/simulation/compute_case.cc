#include "comparison/simulation/compute_case.h"

#include "comparison/support/stopwatch.h"

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

fem::HistoryControl control_of(const FemCase& fem) {
  constexpr int most_after_ramp = 400;
  return {fem.resolution.steps_per_cycle, fem.resolution.n_ramp_cycles + most_after_ramp, fem.resolution.periodicity};
}

}  // namespace

FeAnswer compute_case(const FemCase& fem_case, const Resolution& resolution, BodyStore& bodies) {
  const FemCase fem = at_resolution(fem_case, resolution);
  Stopwatch watch;

  const auto body = bodies.find_or_make(fem.body, [&] {
    const auto mesh = bodies.meshes().mesh_of(fem.body);
    const double mesh_seconds = watch.lap();
    auto operators = assemble_operators(mesh, bodies.meshes().name, fem.body.degree, fem.body.tangential);
    operators.cost.mesh = mesh_seconds;
    return contact_body(condense(std::move(operators)));
  });
  const ProblemsAtSlack at_slack(*body, resolution.active_set_slack);
  const auto problems = at_slack.problems();
  const auto profile = fem::ring_means(problems.normal.compliance, fem.profile);
  const auto control = control_of(fem);

  watch.lap();
  auto normal = fem::normal_history(problems.normal, fem.relaxation, profile, fem.motion, control);
  const auto contact_radius = read_contact_radius(problems.normal, fem, profile, normal);
  const double normal_seconds = watch.lap();
  auto friction = problems.tangential ? fem::friction_history(*problems.tangential, fem.relaxation,
                                                              fem.friction_coefficient, fem.motion, normal, control)
                                      : history_at_rest(problems.normal, fem.friction_coefficient, normal);

  auto answer = read_answer(problems, fem, profile, contact_radius, std::move(normal), std::move(friction));
  answer.body = body->summary;
  answer.seconds = {normal_seconds, watch.lap()};
  return answer;
}

}  // namespace fretval
