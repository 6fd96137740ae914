#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/ring_contact/effective_radii.h"
#include "mdr/stick/surface_fields.h"

namespace fretval {
namespace {

/// Intensities at the edge of the n innermost rings, per `sqrt(k)`, k = force of a unit displacement per radius, over
/// the outermost n_edges edges, the smallest first. By Irwin's relation the intensity is `sqrt(k dW/dc)`, W the energy
/// of stresses inside c; one ring more adds `y^2/2`, y an entry of `L^T x`, L the Cholesky factor of the compliance and
/// x the stress. Stresses themselves alternate from ring to ring next to a singular edge.
Eigen::VectorXd edge_intensities(const fem::Compliance& compliance, const Eigen::VectorXd& stress, Eigen::Index n,
                                 Eigen::Index n_edges) {
  const Eigen::MatrixXd factor = compliance.matrix->topLeftCorner(n, n).llt().matrixL();
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
double worn_edge_error(const ConvergenceMesh& mesh, const ExactScene& exact, double c) {
  const auto unworn = mdr::parabola(1), exact_unworn = mdr::parabola(1 / exact.steepness);
  const auto& compliance = mesh.tangential.compliance;
  // Half way between the indentations at which the edge touches and at which the worn flank does.
  const double indentation = (mdr::transform(unworn, c) + 1) / 2;
  const auto worn = mdr::limiting_profile(unworn, c, 1);
  const auto pressure = fem::static_contact(mesh.normal, means_of(worn, mesh.normal), indentation).pressure;
  const auto n = static_cast<Eigen::Index>(std::lround(c * mesh.n_rings));
  if ((pressure.array() > 0).count() != n) return std::nan("");  // the contact does not end at c
  const auto effective = mdr::limiting_profile(exact_unworn, fem::effective_radii(mesh.normal.compliance).radius[n], 1);
  const double displacement =
      1.5 * friction_coefficient * (indentation - mdr::transform(exact_unworn, effective.stick_radius));
  const Eigen::VectorXd traction =
      compliance.matrix->topLeftCorner(n, n).llt().solve(displacement * compliance.areas.head(n));
  const double exact_ratio = mdr::limiting_traction(effective, 1, displacement, 0).intensity /
                             mdr::limiting_pressure(effective, 1, indentation, 0).intensity;
  return ratio_of_intensities(mesh, traction, pressure, n) / exact_ratio - 1;
}

}  // namespace

/// Ratio of the intensities of traction and pressure at the edge of a fully worn contact at the limit of sticking: mu.
Rows worn_edge_rows(const Meshes& meshes, const ExactScene& exact) {
  const auto error = [&](const ConvergenceMesh& mesh) {
    double worst = 0;
    for (const double c : {0.5, 0.625, 0.75, 0.875}) take_worst(worst, worn_edge_error(mesh, exact, c));
    return worst;
  };
  return {mesh_row({"worn contact",
                    "ratio of edge intensities",
                    "paper, equations (9), (13)",
                    {5e-6, 3, far_field, "edge at the effective radius"}},
                   meshes, error)};
}

}  // namespace fretval
