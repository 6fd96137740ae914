#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/condensation/contact_events.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 60>;

/// In to the indentation 1 at t = 1, and out again.
double indentation(double t) {
  return t * (2 - t);
}

double speed(double t) {
  return 2 - 2 * t;
}

fem::ValueAndRate in_and_out(double t) {
  return {indentation(t), speed(t)};
}

/// `int_begin^t G(t - t') d'(t') dt'`: what a point of the contact touched at `begin` is pressed with.
double load_since(const mdr::PronyBody& body, double begin, double t) {
  return Gauss::integrate([&](double s) { return mdr::relaxation(body, t - s) * speed(s); }, begin, t);
}

/// Ting's force of a parabola of radius 1: while the contact shrinks, its edge is where it was at the instant t1 with
/// `int_t1^t G(t - t') d'(t') dt' = 0`, and `F = int_0^t1 G(t - t') dF_el`, F_el the elastic force at d(t').
class Ting {
 public:
  explicit Ting(mdr::PronyBody body) : body_(std::move(body)) {}

  [[nodiscard]] double operator()(double t) const {
    const double last = touched_before(t);
    // F_el = (16/3) d^(3/2); t' = s^2 takes the root out of its derivative.
    const auto integrand = [&](double s) {
      const double time = s * s;
      return mdr::relaxation(body_, t - time) * 8 * s * std::sqrt(2 - time) * speed(time) * 2 * s;
    };
    return Gauss::integrate(integrand, 0, std::sqrt(last));
  }

 private:
  [[nodiscard]] double touched_before(double t) const {
    if (t <= 1) return t;
    const auto load = [&](double begin) { return load_since(body_, begin, t); };
    if (load(0) <= 0) return 0;  // the indenter has left
    const auto bracket = boost::math::tools::bisect(load, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(48));
    return (bracket.first + bracket.second) / 2;
  }

  mdr::PronyBody body_;
};

/// The same for the rings of a mesh. Their elastic force is linear between the indentations at which one more ring
/// touches, so they act like a row of springs that touch one after another, each until its own load has vanished.
class TingOfRings {
 public:
  TingOfRings(mdr::PronyBody body, const fem::ContactProblem& problem, const Eigen::VectorXd& profile)
      : body_(std::move(body)) {
    const Eigen::VectorXd touch = fem::contact_events(problem.compliance, profile).indentation;
    const auto elastic = [&](double d) {
      return fem::static_contact(problem, profile, d).pressure.dot(problem.compliance.areas);
    };
    double stiffness_before = 0;
    for (Eigen::Index m = 0; m < touch.size() && touch[m] < 1; ++m) {
      const double end = m + 1 < touch.size() ? touch[m + 1] : 1.0;
      const double stiffness = (elastic(end) - elastic(touch[m])) / (end - touch[m]);
      springs_.push_back({1 - std::sqrt(1 - touch[m]), stiffness - stiffness_before});
      stiffness_before = stiffness;
    }
  }

  [[nodiscard]] double operator()(double t) const {
    double force = 0;
    for (const auto& spring : springs_)
      if (spring.touched < t) force += spring.stiffness * std::max(0.0, load_since(body_, spring.touched, t));
    return force;
  }

 private:
  struct Spring {
    double touched, stiffness;  // touched: instant
  };
  mdr::PronyBody body_;
  std::vector<Spring> springs_;
};

/// Largest error relative to the largest force.
double retraction_error(const fem::ContactProblem& problem, int n_steps, double PressingForce::*kind,
                        const std::function<double(double)>& exact) {
  const auto forces = press(problem, means_of(mdr::parabola(1), problem), in_and_out, instants(0, 2, n_steps));
  const auto error = pressing_error(forces, kind, exact);
  return error.largest_error / error.largest_exact;
}

}  // namespace

ConvergenceRow retraction_time_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const auto& problem = meshes.front().normal;
  const TingOfRings expected(exact, problem, means_of(mdr::parabola(1), problem));
  const ConvergenceDemand demand{1.4e-5, 2, 1e-8, std::nullopt, "", 400};
  return time_row({"Ting", "force over time", "Ting 1966, on the elastic force of the same rings", demand},
                  {100, 200, 400, 800},
                  [&](int n) { return retraction_error(problem, n, &PressingForce::sum, expected); });
}

ConvergenceRow retraction_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const Ting expected(exact);
  return mesh_row({"Ting", "force over mesh", "Ting 1966", {1e-5, 3, far_field, 5e-5, far_field_note}}, meshes,
                  [&](const ConvergenceMesh& mesh) {
                    return retraction_error(mesh.normal, 1600, &PressingForce::value, expected);
                  });
}

}  // namespace fretval
