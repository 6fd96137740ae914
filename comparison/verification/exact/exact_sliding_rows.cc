#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/history/friction_history.h"
#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/friction_force.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

const mdr::Profile unworn = mdr::parabola(1);

/// Friction limit of the ring tractions and of the tangential force, and the contact radius.
struct FrictionLimit {
  Eigen::VectorXd rings;  ///< mu p
  double force;           ///< mu times the normal force
  double contact_radius;
};

/// The friction limit under the parabola at an indentation.
FrictionLimit friction_limit(const ConvergenceMesh& mesh, double indentation) {
  const auto contact = fem::static_contact(mesh.normal, means_of(unworn, mesh.normal), indentation);
  const auto normal = fem::contact_force(mesh.normal.series, contact.pressure, contact.gap);
  return {friction_coefficient * contact.pressure, friction_coefficient * normal.force, normal.radius};
}

/// Coulomb friction on an elastic body, from rest, one box problem a step: exact in time as long as the contact does
/// not grow within a step and no ring slips back and forth within one.
class ElasticSliding {
 public:
  explicit ElasticSliding(const ConvergenceMesh& mesh)
      : problem_(mesh.tangential),
        touching_{mesh.normal.series.radii()},
        slip_(Eigen::VectorXd::Zero(problem_.n_rings())),
        traction_(slip_),
        states_(static_cast<std::size_t>(problem_.n_rings()), fem::BoxState::interior),
        zones_(problem_.n_rings()) {}

  /// Steps to a displacement of the indenter. limit: at the end of the step.
  void step(double displacement, const FrictionLimit& limit) {
    limit_ = limit;
    const auto& areas = problem_.compliance.areas;
    const Eigen::VectorXd load = areas.array() * (displacement - slip_.array());
    auto solution = problem_.solver.solve(load, -limit.rings, limit.rings, states_);
    slip_ += solution.residual.cwiseQuotient(areas);
    traction_ = std::move(solution.x);
    touching_.move_to(limit.contact_radius);
    zones_.update(limit.rings, states_, problem_.series.depths(traction_));
  }

  [[nodiscard]] double force() const {
    return fem::friction_force(problem_.series, zones_, touching_, problem_.series.depths(limit_.rings), limit_.force)
        .value;
  }

  /// The stick radius in the last step, under forward slip.
  [[nodiscard]] double stick_radius() const { return stick_radius_of(problem_, limit_.rings, traction_, states_); }

 private:
  const fem::ContactProblem& problem_;
  fem::TouchingRings touching_;
  Eigen::VectorXd slip_, traction_;
  FrictionLimit limit_ = {};
  std::vector<fem::BoxState> states_;
  fem::SlipZones zones_;
};

/// Tangential displacement at which the whole contact slides under the indentation 1.
const double all_slides = 1.5 * friction_coefficient;

/// Cattaneo and Mindlin on the parabola at the indentation 1, over the tangential displacement.
struct CattaneoMindlin {
  ExactScene scene;
  mdr::Profile profile = mdr::parabola(1 / scene.steepness);

  [[nodiscard]] double stick_radius(double u) const {
    return mdr::stick_radius_cattaneo_mindlin(profile, scene.friction_coefficient, 1, u);
  }
  [[nodiscard]] double force(double u) const {
    return mdr::tangential_force_cattaneo_mindlin(profile, scene.modulus, scene.friction_coefficient, 1, u);
  }
  /// Displacement of the indenter by the tangential force: `u = (3 mu/2) [1 - (1 - F_x/(mu F))^(2/3)]`.
  [[nodiscard]] double displacement(double f) const {
    const double mu = scene.friction_coefficient;
    return 1.5 * mu * (1 - std::pow(1 - f / (mu * mdr::normal_force(profile, scene.modulus, 1)), 2.0 / 3));
  }
};

/// Stick radius, relative to the contact radius, force, and the displacement that belongs to the force computed, for
/// stick radii from 0.3 to 0.9.
Rows loading_rows(const Meshes& meshes, const CattaneoMindlin& exact) {
  const auto errors = [&](const ConvergenceMesh& mesh) {
    const auto limit = friction_limit(mesh, 1);
    double radius_error = 0, force_error = 0, displacement_error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double u = all_slides * (1 - mdr::transform(unworn, position(k, 0.3, 0.9)));
      ElasticSliding sliding(mesh);
      sliding.step(u, limit);
      take_worst(radius_error, sliding.stick_radius() - exact.stick_radius(u));
      take_worst(force_error, sliding.force() / exact.force(u) - 1);
      take_worst(displacement_error, exact.displacement(sliding.force()) / u - 1);
    }
    return std::vector<double>{radius_error, force_error, displacement_error};
  };
  const char *solution = "Cattaneo-Mindlin", *source = "Cattaneo 1938, Mindlin 1949";
  const ConvergenceDemand demand{2e-6, 3, far_field, far_field_note};
  return mesh_rows(Rows{{solution, "stick radius", source, {5e-6, 3, far_field, far_field_note}},
                        {solution, "force", source, demand},
                        {solution, "displacement", source, demand}},
                   meshes, errors);
}

/// Energy that a cycle between +-u_x dissipates, from the force-displacement curve of the first loading by Masing's
/// rule: `W = 8 int_0^u F du - 4 u F(u)`; u_x from 0.3 to 0.9 of what makes the whole contact slide.
ConvergenceRow cycle_row(const Meshes& meshes, const CattaneoMindlin& exact) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  fem::HistoryControl control;
  control.steps_per_cycle = 720;
  const auto error = [&](const ConvergenceMesh& mesh) {
    fem::Motion motion = fem::one_frequency(1, 0, 0, 0.0);
    motion.n_ramp_cycles = 1;
    const auto profile = means_of(unworn, mesh.normal);
    const fem::RelaxationModel elastic;
    double worst = 0;
    for (int k = 0; k < n_positions; k += 4) {
      const double u = motion.tangential.front().amplitude = position(k, 0.3, 0.9) * all_slides;
      const double work = 8 * Gauss::integrate([&](double x) { return exact.force(x); }, 0, u) - 4 * u * exact.force(u);
      const auto history = fem::contact_history(
          {mesh.normal, elastic, profile, motion, control.steps_per_cycle},
          {mesh.tangential, elastic, friction_coefficient, motion, control.steps_per_cycle}, control);
      take_worst(worst, history.friction.dissipated_energy / work - 1);
    }
    return worst;
  };
  return mesh_row(
      {"Mindlin-Deresiewicz", "energy of a cycle", "Mindlin & Deresiewicz 1953", {1e-4, 3, far_field, far_field_note}},
      meshes, error);
}

/// Force between +u_x and -u_x after the first loading to u_x, relative to the largest: by Masing's rule
/// `F(u_x) - 2 F((u_x - u)/2)`; u_x 0.3, 0.6 and 0.9 of what makes the whole contact slide.
ConvergenceRow unloading_row(const Meshes& meshes, const CattaneoMindlin& exact) {
  const auto error = [&](const ConvergenceMesh& mesh) {
    const auto limit = friction_limit(mesh, 1);
    double worst = 0;
    for (const double amplitude : {0.3, 0.6, 0.9}) {
      const double reversal = amplitude * all_slides, largest = exact.force(reversal);
      ElasticSliding sliding(mesh);
      sliding.step(reversal, limit);
      for (int k = 0; k < n_positions; ++k) {
        const double u = position(k, reversal, -reversal);
        sliding.step(u, limit);
        take_worst(worst, (sliding.force() - (largest - 2 * exact.force((reversal - u) / 2))) / largest);
      }
    }
    return worst;
  };
  return mesh_row({"Mindlin-Deresiewicz",
                   "force while unloading",
                   "Mindlin & Deresiewicz 1953",
                   {1e-5, 1, far_field, "discs of n rings are 0.0025 rings larger tangentially than normally"}},
                  meshes, error);
}

/// A parabola pressed in to `first`, then moved on obliquely: du_x/dd below the slope at which the contact slides up to
/// `second`, above it up to `last`.
struct ObliqueLoading {
  double first, second, last;
  double sticking_slope, slipping_slope;

  [[nodiscard]] double displacement(double d) const {
    return sticking_slope * (std::clamp(d, first, second) - first) + slipping_slope * std::max(0.0, d - second);
  }
};
constexpr ObliqueLoading loading{0.4, 0.8, 0.925, 0.3, 3};

/// Indentations of both parts of the loading, with those among them at which a ring touches: the contact does not
/// change within a step that ends there, and there is no error of time.
std::vector<double> oblique_indentations(const ConvergenceMesh& mesh) {
  std::vector<double> all;
  for (int k = 0; k < n_positions; ++k) {
    all.push_back(position(k, loading.first, loading.second));
    all.push_back(position(k, loading.second, loading.last));
  }
  for (const double d : fem::contact_events(mesh.normal.compliance, means_of(unworn, mesh.normal)).indentation)
    if (loading.first < d && d < loading.last) all.push_back(d);
  std::sort(all.begin(), all.end());
  return all;
}

/// Jaeger's superposition of normal contacts, over the indentation. A point that joins the contact while everything
/// sticks moves along from then on; with s = (2/3) du_x/dd of the sticking part, F the normal force and D = g(c) the
/// depth at the stick radius
///   `mu (d - D) = (2/3) u_x - s (max(D, first) - first)`,
///   `F_x = mu [F(d) - F(D)] + s [F(max(D, first)) - F(first)]`;   D = d while everything sticks.
struct Jaeger {
  ExactScene scene;
  mdr::Profile profile = mdr::parabola(1 / scene.steepness);
  double share = 2.0 / 3 * loading.sticking_slope;

  [[nodiscard]] double stick_depth(double d) const {
    if (d <= loading.second) return d;
    // Inside the first contact a point sticks since u = 0, outside it since the contact came to it.
    const double mu = scene.friction_coefficient, u = loading.displacement(d), inside = d - u / (1.5 * mu);
    if (inside <= loading.first) return inside;
    return (mu * d - 2.0 / 3 * u - share * loading.first) / (mu - share);
  }
  [[nodiscard]] double stick_radius(double d) const { return mdr::contact_radius(profile, stick_depth(d)); }
  [[nodiscard]] double force(double d) const {
    const auto normal_force = [&](double depth) { return mdr::normal_force(profile, scene.modulus, depth); };
    const double stuck = stick_depth(d);
    return scene.friction_coefficient * (normal_force(d) - normal_force(stuck)) +
           share * (normal_force(std::max(stuck, loading.first)) - normal_force(loading.first));
  }
};

}  // namespace

Rows sliding_rows(const Meshes& meshes, const ExactScene& exact) {
  Rows rows = loading_rows(meshes, {exact});
  append(rows, {cycle_row(meshes, {exact}), unloading_row(meshes, {exact})});
  return rows;
}

/// Force relative to the largest one, and the stick radius over the contact radius while it is inside the first
/// contact.
Rows oblique_rows(const Meshes& meshes, const ExactScene& scene) {
  const Jaeger exact{scene};
  const double first_contact = mdr::contact_radius(unworn, loading.first);
  const auto errors = [&](const ConvergenceMesh& mesh) {
    ElasticSliding sliding(mesh);
    double force_error = 0, radius_error = 0;
    int n_radii = 0;
    for (const double d : oblique_indentations(mesh)) {
      sliding.step(loading.displacement(d), friction_limit(mesh, d));
      take_worst(force_error, (sliding.force() - exact.force(d)) / exact.force(loading.last));
      const double radius = exact.stick_radius(d);
      if (d <= loading.second || radius > first_contact) continue;
      take_worst(radius_error, (sliding.stick_radius() - radius) / mdr::contact_radius(unworn, d));
      ++n_radii;
    }
    return std::vector<double>{force_error, n_radii > 0 ? radius_error : std::nan("")};
  };
  const char *solution = "oblique loading", *source = "Jaeger 1993";
  const char* kink_note =
      "inside the first contact: less than six rings outside it the fit of the stick edge meets the kink of the "
      "traction there, and is off by up to a ring";
  return mesh_rows(Rows{{solution, "force", source, {3e-6, 2, far_field, far_field_note}},
                        {solution, "stick radius", source, {1e-6, 3, far_field, kink_note}}},
                   meshes, errors);
}

}  // namespace fretval
