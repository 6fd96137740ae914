#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/condensation/effective_radii.h"
#include "fem/stick_zone/stick_radius.h"
#include "mdr/profiles/indentation.h"
#include "mdr/stick/surface_fields.h"

namespace fretval {

namespace {
/// Tangential displacement at which the whole contact slides under the indentation 1.
constexpr double all_slides = 1.5 * friction_coefficient;
}  // namespace

ExactSliding exact_sliding() {
  const auto profile = mdr::parabola(1);
  const double mu = friction_coefficient, normal_force = mdr::normal_force(profile, 1, 1);
  return {[=](double u) { return mdr::stick_radius_cattaneo_mindlin(profile, mu, 1, u); },
          [=](double u) { return mdr::tangential_force_cattaneo_mindlin(profile, 1, mu, 1, u); },
          [=](double f) { return 1.5 * mu * (1 - std::pow(1 - f / (mu * normal_force), 2.0 / 3)); }};
}

std::vector<ConvergenceRow> sliding_rows(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact) {
  const auto profile = mdr::parabola(1);
  const auto errors = [&](const ConvergenceMesh& mesh) {
    const auto limit = friction_limit(mesh, profile, 1);
    double radius_error = 0, force_error = 0, displacement_error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double u = all_slides * (1 - mdr::transform(profile, position(k, 0.3, 0.9)));
      ElasticSliding sliding(mesh);
      sliding.step(u, limit);
      take_worst(radius_error, sliding.stick_radius() - exact.stick_radius(u));
      take_worst(force_error, sliding.force() / exact.force(u) - 1);
      take_worst(displacement_error, exact.displacement(sliding.force()) / u - 1);
    }
    return std::vector<double>{radius_error, force_error, displacement_error};
  };
  const std::string solution = "Cattaneo-Mindlin", source = "Cattaneo 1938, Mindlin 1949";
  const ConvergenceDemand demand{2e-6, 3, far_field, 1e-5, far_field_note};
  return mesh_rows({{solution, "stick radius", source, {5e-6, 3, far_field, 5e-6, far_field_note}},
                    {solution, "force", source, demand},
                    {solution, "displacement", source, demand}},
                   meshes, errors);
}

ConvergenceRow cycle_row(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact) {
  fem::HistoryControl control;
  control.steps_per_cycle = 720;
  const auto error = [&](const ConvergenceMesh& mesh) {
    fem::Motion motion{1, 0, 0, 0.0, 1};
    const auto profile = means_of(mdr::parabola(1), mesh.normal);
    const fem::RelaxationModel elastic;
    double worst = 0;
    for (int k = 0; k < n_positions; k += 4) {
      const double u = motion.tangential_amplitude = position(k, 0.3, 0.9) * all_slides;
      const double work =
          8 * boost::math::quadrature::gauss<double, 30>::integrate(exact.force, 0, u) - 4 * u * exact.force(u);
      const auto history = fem::contact_history(
          {mesh.normal, elastic, profile, motion, control.steps_per_cycle},
          {mesh.tangential, elastic, friction_coefficient, motion, control.steps_per_cycle}, control);
      take_worst(worst, history.friction.dissipated_energy / work - 1);
    }
    return worst;
  };
  return mesh_row({"Mindlin-Deresiewicz",
                   "energy of a cycle",
                   "Mindlin & Deresiewicz 1953",
                   {1e-4, 3, far_field, 2e-4, far_field_note}},
                  meshes, error);
}

ConvergenceRow unloading_row(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact) {
  const auto error = [&](const ConvergenceMesh& mesh) {
    const auto limit = friction_limit(mesh, mdr::parabola(1), 1);
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
                   {1e-5, 1, far_field, 1e-5, edges_note}},
                  meshes, error);
}

namespace {

/// Intensities at the edge of the n innermost rings, per `sqrt(k)`, k = force of a unit displacement per radius, over
/// the outermost n_edges edges, the smallest first. By Irwin's relation the intensity is `sqrt(k dW/dc)`, W the energy
/// of stresses inside c; one ring more adds `y^2/2`, y an entry of `L^T x`, L the Cholesky factor of the compliance and
/// x the stress. Stresses themselves alternate from ring to ring next to a singular edge.
Eigen::VectorXd edge_intensities(const fem::Compliance& compliance, const Eigen::VectorXd& stress, Eigen::Index n,
                                 Eigen::Index n_edges) {
  const Eigen::MatrixXd factor = compliance.matrix.topLeftCorner(n, n).llt().matrixL();
  const Eigen::VectorXd radii = fem::effective_radii(compliance).radius.segment(n - n_edges, n_edges + 1);
  const Eigen::VectorXd widths = radii.tail(n_edges) - radii.head(n_edges);
  const Eigen::VectorXd roots = factor.transpose() * stress.head(n);
  return roots.tail(n_edges).cwiseQuotient(widths.cwiseSqrt());
}

/// Ratio of the intensities of traction and pressure at the effective edge of the n innermost rings: the parabola
/// through three edges, continued by half a ring.
double ratio_of_intensities(const ConvergenceMesh& mesh, const Eigen::VectorXd& traction,
                            const Eigen::VectorXd& pressure, Eigen::Index n) {
  const Eigen::VectorXd inverse = edge_intensities(mesh.normal.compliance, pressure, n, 3)
                                      .cwiseQuotient(edge_intensities(mesh.tangential.compliance, traction, n, 3));
  // sqrt(k_x/k_z), Mindlin's ratio of the tangential and the normal stiffness of an incompressible half-space.
  const double mindlin = std::sqrt(2.0 / 3);
  return mindlin / (3.0 / 8 * inverse[0] - 10.0 / 8 * inverse[1] + 15.0 / 8 * inverse[2]);
}

/// Error of the ratio under a parabola that is worn outside c.
double worn_edge_error(const ConvergenceMesh& mesh, const mdr::Profile& exact, double c) {
  const auto unworn = mdr::parabola(1);
  const auto& compliance = mesh.tangential.compliance;
  // Half way between the indentations at which the edge touches and at which the worn flank does.
  const double indentation = (mdr::transform(unworn, c) + 1) / 2;
  const auto worn = mdr::limiting_profile(unworn, c, 1);
  const auto means = fem::ring_means(mesh.normal.compliance, [&](double r) { return mdr::shape(worn, r); });
  const auto pressure = fem::static_contact(mesh.normal, means, indentation).pressure;
  const auto n = static_cast<Eigen::Index>(std::lround(c * mesh.n_rings));
  if ((pressure.array() > 0).count() != n) return std::nan("");  // the contact does not end at c
  const auto effective = mdr::limiting_profile(exact, fem::effective_radii(mesh.normal.compliance).radius[n], 1);
  const double displacement =
      1.5 * friction_coefficient * (indentation - mdr::transform(exact, effective.stick_radius));
  const Eigen::VectorXd traction =
      compliance.matrix.topLeftCorner(n, n).llt().solve(displacement * compliance.areas.head(n));
  const double exact_ratio = mdr::limiting_traction(effective, 1, displacement, 0).intensity /
                             mdr::limiting_pressure(effective, 1, indentation, 0).intensity;
  return ratio_of_intensities(mesh, traction, pressure, n) / exact_ratio - 1;
}

}  // namespace

ConvergenceRow worn_edge_row(const std::vector<ConvergenceMesh>& meshes, const mdr::Profile& exact) {
  const auto error = [&](const ConvergenceMesh& mesh) {
    double worst = 0;
    for (const double c : {0.5, 0.625, 0.75, 0.875}) take_worst(worst, worn_edge_error(mesh, exact, c));
    return worst;
  };
  return mesh_row({"worn contact",
                   "ratio of edge intensities",
                   "paper, equations (9), (13)",
                   {5e-6, 3, far_field, std::nullopt, "edge at the effective radius"}},
                  meshes, error);
}

}  // namespace fretval
