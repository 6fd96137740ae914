#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/history/normal_history.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/support/solver_error.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 60>;
using Path = std::function<fem::ValueAndRate(double)>;

const mdr::Profile parabola = mdr::parabola(1);

/// The force of an indenter that is pressed into a viscoelastic body.
struct PressingForce {
  double time, value;  ///< time: at which forces are balanced
  double sum;          ///< over the rings, which the springs of the same rings reproduce exactly
};

/// Forces in the intervals between the instants, from rest along a path. profile: ring means. Throws SolverError when
/// the contact reaches the end of the contact line.
std::vector<PressingForce> press(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, const Path& path,
                                 const std::vector<double>& instants) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const auto model = fem_model(ExactScene().body);
  fem::RingState state{Eigen::VectorXd::Zero(n),
                       Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(model.times.size()))};
  std::vector<fem::BoxState> contact(static_cast<std::size_t>(n), fem::BoxState::lower);
  const Eigen::VectorXd ends = problem.series.displacements(profile);
  fem::FreeSurface surface(problem.series, state, 0);
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(n);
  std::vector<PressingForce> forces;
  for (std::size_t k = 1; k < instants.size(); ++k) {
    const double begin = instants[k - 1], end = instants[k];
    const fem::RelaxationStep step(model, end - begin);
    const double fraction = step.fraction(), balance = begin + fraction * (end - begin);
    const Eigen::VectorXd gap = (state.displacement + profile).array() - path(begin).value;
    const auto move = fem::indenter_move(path, begin, end);
    const auto& series = problem.series;
    const auto to_balance = fem::indenter_move(path, begin, balance);
    const Eigen::VectorXd standing = step.response_without_slip(state, fem::standing_still);
    fem::RingCourses courses;
    fem::find_courses(series, step,
                      {series.depths(pressure), series.displacements(standing), series.displacements(gap)}, to_balance,
                      move.increment, courses);
    const Eigen::VectorXd by_itself = courses.left_behind(move.increment);
    Eigen::VectorXd held = standing + step.response_to(to_balance) * courses.driven;
    if (courses.has_turns) held += courses.response;
    const Eigen::VectorXd load = areas.cwiseProduct(held + step.instantaneous() * (by_itself - gap));
    const auto solution = problem.solver.solve(
        load, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()), contact);
    if (solution.x[n - 1] > 0) throw fem::SolverError("the contact reaches the end of the contact line");
    const Eigen::VectorXd new_gap = -solution.residual.cwiseQuotient(areas) / step.instantaneous();
    step.advance(state, move, gap - new_gap - by_itself, courses.driven);
    if (courses.has_turns) state.memory += courses.memory;
    Eigen::VectorXd depths = series.depths(solution.x);
    courses.to_instant(depths);
    fem::Opening opening;
    surface.find_opening(step, ends, path(balance).value, opening);
    const auto force = fem::contact_force(series, {solution.x, depths, opening});
    surface.advance(step, state, contact, force.radius);
    pressure = solution.x;
    forces.push_back({balance, force.force, solution.x.dot(areas)});
  }
  return forces;
}

/// 0, first, and n equal steps up to the end.
std::vector<double> instants(double first, double end, int n) {
  std::vector<double> t{0};
  if (first > 0) t.push_back(first);
  for (int k = 1; k <= n; ++k) t.push_back(first + (end - first) * k / n);
  return t;
}

/// A unit step of the indentation, but for a rise this short: a step to a relative 1e-9/tau. Its rate is quadratic, as
/// the scheme takes it.
constexpr double step_rise = 1e-9;
fem::ValueAndRate unit_step(double t) {
  const double x = std::min(t / step_rise, 1.0);
  return {x * x * (3 - 2 * x), 6 * x * (1 - x) / step_rise};
}

/// Largest error of the force after a step of the indentation, in n steps of time: over `elastic G(t)/G0`.
double relaxing_force_error(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, double indentation,
                            double elastic, const mdr::PronyBody& exact, int n_steps) {
  const auto path = [indentation](double t) {
    const auto step = unit_step(t);
    return fem::ValueAndRate{indentation * step.value, indentation * step.rate};
  };
  double worst = 0;
  for (const auto& force : press(problem, profile, path, instants(step_rise, 1, n_steps)))
    if (force.time > step_rise)
      take_worst(worst, force.value * exact.relaxed_modulus / (elastic * mdr::relaxation(exact, force.time)) - 1);
  return worst;
}

/// A parabola is pressed in, and maybe pulled out again, from t = 1 on.
struct Pressing {
  const char *name, *source;
  double (*indentation)(double t);
  double (*speed)(double t);
  double (*touched)(double d);  ///< instant at which it comes to an indentation
  double end;
  ConvergenceDemand over_time, over_mesh;
  std::vector<int> n_steps;

  [[nodiscard]] fem::ValueAndRate operator()(double t) const { return {indentation(t), speed(t)}; }
};

/// `int_begin^t G(t - t') d'(t') dt'`: what a point of the contact touched at `begin` is pressed with.
double load_since(const mdr::PronyBody& body, const Pressing& pressing, double begin, double t) {
  return Gauss::integrate([&](double s) { return mdr::relaxation(body, t - s) * pressing.speed(s); }, begin, t);
}

/// Ting's force of a parabola of radius 1: while the contact shrinks, its edge is where it was at the instant t1 with
/// `int_t1^t G(t - t') d'(t') dt' = 0`, and `F = int_0^t1 G(t - t') dF_el`, F_el the elastic force at d(t'); while it
/// grows, t1 = t, which is Lee and Radok's.
double ting_force(const mdr::PronyBody& body, const Pressing& pressing, double t) {
  const auto load = [&](double begin) { return load_since(body, pressing, begin, t); };
  double last = t;
  if (t > 1) {
    if (load(0) <= 0) return 0;  // the indenter has left
    const auto bracket = boost::math::tools::bisect(load, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(48));
    last = (bracket.first + bracket.second) / 2;
  }
  // F_el = (16/3) d^(3/2); t' = s^2 takes the root out of its derivative.
  const auto integrand = [&](double s) {
    const double time = s * s;
    return mdr::relaxation(body, t - time) * 8 * std::sqrt(pressing.indentation(time)) * pressing.speed(time) * 2 * s;
  };
  return Gauss::integrate(integrand, 0, std::sqrt(last));
}

/// Ting's force for the rings of a mesh. Their elastic force is linear between the indentations at which one more ring
/// touches, so that they act like a row of springs that touch one after another, each until its own load has vanished.
class TingOfRings {
 public:
  TingOfRings(mdr::PronyBody body, const Pressing& pressing, const fem::ContactProblem& problem)
      : body_(std::move(body)), pressing_(pressing) {
    const auto profile = means_of(parabola, problem);
    const Eigen::VectorXd touch = fem::contact_events(problem.compliance, profile).indentation;
    const auto elastic = [&](double d) {
      return fem::static_contact(problem, profile, d).pressure.dot(problem.compliance.areas);
    };
    double stiffness_before = 0;
    for (Eigen::Index m = 0; m < touch.size() && touch[m] < 1; ++m) {
      const double end = m + 1 < touch.size() ? touch[m + 1] : 1.0;
      const double stiffness = (elastic(end) - elastic(touch[m])) / (end - touch[m]);
      springs_.push_back({pressing.touched(touch[m]), stiffness - stiffness_before});
      stiffness_before = stiffness;
    }
  }

  [[nodiscard]] double operator()(double t) const {
    double force = 0;
    for (const auto& spring : springs_)
      if (spring.touched < t)
        force += spring.stiffness * std::max(0.0, load_since(body_, pressing_, spring.touched, t));
    return force;
  }

 private:
  struct Spring {
    double touched, stiffness;  // touched: instant
  };
  mdr::PronyBody body_;
  Pressing pressing_;
  std::vector<Spring> springs_;
};

/// Largest error of a force over time, once t > 0.3, relative to the largest force.
double pressing_error(const fem::ContactProblem& problem, const Pressing& pressing, int n_steps,
                      double PressingForce::*kind, const std::function<double(double)>& exact) {
  double worst = 0, largest = 0;
  for (const auto& force : press(problem, means_of(parabola, problem), pressing, instants(0, pressing.end, n_steps))) {
    if (force.time <= 0.3 && !std::isnan(force.*kind)) continue;
    const double expected = exact(force.time);
    largest = std::max(largest, expected);
    take_worst(worst, force.*kind - expected);
  }
  return worst / largest;
}

}  // namespace

/// The force after a step of the indentation, `G(t)/G0` times the elastic one: of a flat punch over the elastic force
/// of the same rings, which the scheme integrates exactly in time, and of a parabola over Hertz.
Rows relaxation_rows(const Meshes& meshes, const ExactScene& exact) {
  const auto& problem = meshes.front().normal;
  const Eigen::VectorXd punch = fem::ring_means(problem.compliance, [](double r) { return r < 1 ? 0.0 : 10.0; });
  const auto contact = fem::static_contact(problem, punch, 1);
  const double elastic = fem::contact_force(problem.series, contact.pressure, contact.gap).force;
  const auto hertz_error = [&](const ConvergenceMesh& mesh) {
    const auto profile = means_of(parabola, mesh.normal);
    double worst = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(parabola, position(k, 0.8, 1));
      const double hertz = mdr::normal_force(parabola, exact.modulus, indentation);
      take_worst(worst, relaxing_force_error(mesh.normal, profile, indentation, hertz, exact.body, 8));
    }
    return worst;
  };
  return {
      time_row({"flat punch, step",
                "relaxing force",
                "correspondence, Lee 1955, on the elastic force of the same rings",
                {1e-8, 0, 1e-8, "floor: rise time of the step"}},
               {8, 16, 32, 64}, [&](int n) { return relaxing_force_error(problem, punch, 1, elastic, exact.body, n); }),
      mesh_row(
          {"Hertz, step", "relaxing force", "Hertz 1882, correspondence, Lee 1955", {1e-6, 3, bulk_floor, bulk_note}},
          meshes, hertz_error)};
}

/// The force of a parabola pressed in at a constant rate, and of one pressed in and pulled out, d = t (2 - t), until it
/// has left: over the number of steps, on the coarsest mesh, against the integral of the elastic force of the same
/// rings, and over the mesh, of the exact one.
Rows pressing_rows(const Meshes& meshes, const ExactScene& exact) {
  const Pressing in{"Lee-Radok",
                    "Lee & Radok 1960",
                    [](double t) { return t; },
                    [](double) { return 1.0; },
                    [](double d) { return d; },
                    1,
                    {1e-12, 2, 1e-8, "", 200},
                    {1e-6, 3, far_field, far_field_note},
                    {50, 100, 200, 400}};
  const Pressing in_and_out{"Ting",
                            "Ting 1966",
                            [](double t) { return t * (2 - t); },
                            [](double t) { return 2 - 2 * t; },
                            [](double d) { return 1 - std::sqrt(1 - d); },
                            2,
                            {1e-8, 2, 1e-8, "", 400},
                            {1e-5, 3, far_field, far_field_note},
                            {100, 200, 400, 800}};
  const auto& problem = meshes.front().normal;
  Rows rows;
  for (const auto& pressing : {in, in_and_out}) {
    const TingOfRings of_rings(exact.body, pressing, problem);
    const auto of_body = [&](double t) { return ting_force(exact.body, pressing, t); };
    const std::string source = pressing.source;
    rows.push_back(time_row(
        {pressing.name, "force over time", source + ", on the elastic force of the same rings", pressing.over_time},
        pressing.n_steps, [&](int n) { return pressing_error(problem, pressing, n, &PressingForce::sum, of_rings); }));
    rows.push_back(mesh_row({pressing.name, "force over mesh", source, pressing.over_mesh}, meshes,
                            [&](const ConvergenceMesh& mesh) {
                              return pressing_error(mesh.normal, pressing, 1600, &PressingForce::value, of_body);
                            }));
  }
  return rows;
}

}  // namespace fretval
