#include "comparison/exact_rows.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "comparison/body.h"
#include "fem/edge.h"
#include "fem/friction_history.h"
#include "mdr/indentation.h"
#include "mdr/spring_energy.h"
#include "mdr/surface_fields.h"
#include "meshes/grading.h"

namespace fretval {
namespace {

using Eigen::Index;

constexpr double friction_coefficient = 0.4;
constexpr int n_positions = 193;

// What cutting the half-space off at 25 contact radii leaves of the errors of radii and forces.
constexpr double far_field = 1e-7;

/// Position k of n_positions between two ends.
double position(int k, double first, double last) {
  return first + (last - first) * k / (n_positions - 1);
}

Eigen::VectorXd means_of(const mdr::Profile& profile, const fem::ContactProblem& problem) {
  return fem::ring_means(problem.compliance, [&](double r) { return mdr::shape(profile, r); });
}

/// Largest absolute value, NaN if any is.
void take_worst(double& worst, double error) {
  if (!(std::abs(error) <= worst)) worst = std::isnan(worst) ? worst : std::abs(error);
}

LadderRow mesh_row(const std::string& scene, const std::string& quantity, const std::string& source,
                   const std::vector<LadderMesh>& meshes, const LadderDemand& demand,
                   const std::function<double(const LadderMesh&)>& error) {
  LadderRow row{scene, quantity, source, "rings", {}, {}, demand};
  for (const auto& mesh : meshes) {
    row.resolutions.push_back(mesh.n_rings);
    row.errors.push_back(error(mesh));
  }
  return row;
}

}  // namespace

std::vector<LadderMesh> half_space_ladder(const std::vector<int>& n_rings) {
  std::vector<LadderMesh> meshes;
  for (const int n : n_rings) {
    Body body = make_body({meshes::uniform_nodes(1.125, static_cast<unsigned>(n) * 9 / 8), 0.15, 25, 3});
    meshes.push_back({n, std::move(body.normal.contact), std::move(body.tangential->contact)});
  }
  return meshes;
}

ExactIndentation exact_indentation(const std::string& name, const std::string& source, double exponent) {
  const auto profile = mdr::power_law(1 / mdr::transform_factor(exponent), exponent);
  return {name, source, profile, [profile](double d) { return mdr::contact_radius(profile, d); },
          [profile](double d) { return mdr::normal_force(profile, 1, d); }};
}

std::vector<LadderRow> indentation_rows(const std::vector<LadderMesh>& meshes, const ExactIndentation& exact,
                                        const LadderDemand& radius, const LadderDemand& force) {
  const auto worst = [&](const LadderMesh& mesh, const auto& error_of) {
    const Eigen::VectorXd profile = means_of(exact.profile, mesh.normal);
    double error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(exact.profile, position(k, 0.8, 1));
      take_worst(error, error_of(fem::normal_contact(mesh.normal, profile, indentation), indentation));
    }
    return error;
  };
  const auto radius_error = [&](const LadderMesh& mesh) {
    const auto events = fem::contact_events(mesh.normal.compliance, means_of(exact.profile, mesh.normal));
    return worst(mesh, [&](const fem::NormalContact& contact, double indentation) {
      fem::NormalHistory history{};
      history.smallest_gap = contact.gap;
      return fem::largest_contact_radius(history, events).radius / exact.contact_radius(indentation) - 1;
    });
  };
  const auto force_error = [&](const LadderMesh& mesh) {
    return worst(mesh, [&](const fem::NormalContact& contact, double indentation) {
      return contact.pressure.dot(mesh.normal.compliance.areas) / exact.force(indentation) - 1;
    });
  };
  return {mesh_row(exact.name, "contact radius", exact.source, meshes, radius, radius_error),
          mesh_row(exact.name, "force", exact.source, meshes, force, force_error)};
}

namespace {

/// Force of a unit displacement of the n innermost rings.
double force_of_stuck_rings(const fem::Compliance& compliance, Index n) {
  const Eigen::MatrixXd inside = compliance.matrix.topLeftCorner(n, n);
  const Eigen::VectorXd areas = compliance.areas.head(n);
  return areas.dot(inside.llt().solve(areas));
}

struct Sliding {
  double stick_radius, force;
};

/// The parabola at the indentation 1 after a tangential displacement: one box problem.
Sliding slide(const LadderMesh& mesh, const Eigen::VectorXd& limit, double displacement) {
  const auto& compliance = mesh.tangential.compliance;
  std::vector<fem::BoxState> states(static_cast<std::size_t>(limit.size()), fem::BoxState::interior);
  const Eigen::VectorXd traction =
      mesh.tangential.solver.solve(displacement * compliance.areas, -limit, limit, states).x;
  Index n_stuck = 0;
  while (n_stuck < limit.size() && limit[n_stuck] > 0 &&
         states[static_cast<std::size_t>(n_stuck)] == fem::BoxState::interior)
    ++n_stuck;
  return {fem::stick_radius(compliance, fem::SlipReserve(mesh.tangential).of(limit - traction), n_stuck).radius,
          traction.dot(compliance.areas)};
}

Eigen::VectorXd friction_limit(const LadderMesh& mesh, const mdr::Profile& profile) {
  return friction_coefficient * fem::normal_contact(mesh.normal, means_of(profile, mesh.normal), 1).pressure;
}

}  // namespace

ExactPunch exact_punch() {
  const auto body = mdr::elastic(1);
  return {mdr::normal_scale(body), mdr::tangential_scale(body)};
}

std::vector<LadderRow> punch_rows(const std::vector<LadderMesh>& meshes, const ExactPunch& exact) {
  struct Punch {
    const char *name, *source;
    bool normal;
    double force;
  };
  const LadderDemand nominal{2e-3, 1, far_field, 1e-5, "n rings act like a disc 0.1 to 0.15 rings smaller"};
  const LadderDemand effective{1e-6, 3, 2 * far_field, 1e-5, "floor: far field"};
  std::vector<LadderRow> rows;
  for (const auto& punch : {Punch{"flat punch", "Boussinesq 1885, Sneddon 1965", true, exact.normal},
                            Punch{"full stick", "Mindlin 1949", false, exact.tangential}}) {
    const auto compliance = [&](const LadderMesh& mesh) -> const fem::Compliance& {
      return (punch.normal ? mesh.normal : mesh.tangential).compliance;
    };
    const auto error = [&](const LadderMesh& mesh) {
      return force_of_stuck_rings(compliance(mesh), mesh.n_rings) / punch.force - 1;
    };
    const auto error_per_radius = [&](const LadderMesh& mesh) {
      return (1 + error(mesh)) / fem::effective_radii(compliance(mesh)).radius[mesh.n_rings] - 1;
    };
    rows.push_back(mesh_row(punch.name, "force", punch.source, meshes, nominal, error));
    rows.push_back(
        mesh_row(punch.name, "force over effective radius", punch.source, meshes, effective, error_per_radius));
  }
  return rows;
}

ExactSliding exact_sliding() {
  const auto profile = mdr::parabola(1);
  return {
      [profile](double u) { return mdr::stick_radius_cattaneo_mindlin(profile, friction_coefficient, 1, u); },
      [profile](double u) { return mdr::tangential_force_cattaneo_mindlin(profile, 1, friction_coefficient, 1, u); }};
}

std::vector<LadderRow> sliding_rows(const std::vector<LadderMesh>& meshes, const ExactSliding& exact) {
  const auto profile = mdr::parabola(1);
  const auto worst = [&](const LadderMesh& mesh, const auto& error_of) {
    const auto limit = friction_limit(mesh, profile);
    double error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double displacement = 1.5 * friction_coefficient * (1 - mdr::transform(profile, position(k, 0.3, 0.9)));
      take_worst(error, error_of(slide(mesh, limit, displacement), displacement));
    }
    return error;
  };
  const auto radius_error = [&](const LadderMesh& mesh) {
    return worst(mesh, [&](const Sliding& sliding, double u) { return sliding.stick_radius - exact.stick_radius(u); });
  };
  const auto force_error = [&](const LadderMesh& mesh) {
    return worst(mesh, [&](const Sliding& sliding, double u) { return sliding.force / exact.force(u) - 1; });
  };
  const std::string source = "Cattaneo 1938, Mindlin 1949";
  const LadderDemand radius{5e-6, 3, far_field, 5e-6, "floor: far field"};
  const LadderDemand force{5e-4, 2, far_field, 1e-5, "constant pressure on rings: h^2"};
  return {mesh_row("Cattaneo-Mindlin", "stick radius", source, meshes, radius, radius_error),
          mesh_row("Cattaneo-Mindlin", "force", source, meshes, force, force_error)};
}

LadderRow cycle_row(const std::vector<LadderMesh>& meshes, const ExactSliding& exact) {
  const double all_slides = 1.5 * friction_coefficient;
  fem::HistoryControl control;
  control.steps_per_cycle = 720;
  const auto error = [&](const LadderMesh& mesh) {
    fem::Motion motion{1, 0, 0, 0.0, 1};
    const auto profile = means_of(mdr::parabola(1), mesh.normal);
    const auto normal = fem::normal_history(mesh.normal, {}, profile, motion, control);
    double worst = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double u = motion.tangential_amplitude = position(k, 0.3, 0.9) * all_slides;
      const double work =
          8 * boost::math::quadrature::gauss<double, 30>::integrate(exact.force, 0, u) - 4 * u * exact.force(u);
      const auto history = fem::friction_history(mesh.tangential, {}, friction_coefficient, motion, normal, control);
      take_worst(worst, history.dissipated_energy / work - 1);
    }
    return worst;
  };
  return mesh_row("Mindlin-Deresiewicz", "energy of a cycle", "Mindlin & Deresiewicz 1953", meshes,
                  {5e-3, 2, far_field, 2e-4, "constant pressure on rings: h^2"}, error);
}

namespace {

/// Intensities at the edge of the n innermost rings, per `sqrt(k)`, k = force of a unit displacement per radius, over
/// the outermost n_edges edges, the smallest first. By Irwin's relation the intensity is `sqrt(k dW/dc)`, W the energy
/// of stresses inside c; one ring more adds `y^2/2`, y an entry of `L^T x`, L the Cholesky factor of the compliance and
/// x the stress. Stresses themselves alternate from ring to ring next to a singular edge.
Eigen::VectorXd edge_intensities(const fem::Compliance& compliance, const Eigen::VectorXd& stress, Index n,
                                 Index n_edges) {
  const Eigen::MatrixXd factor = compliance.matrix.topLeftCorner(n, n).llt().matrixL();
  const Eigen::VectorXd radii = fem::effective_radii(compliance).radius.segment(n - n_edges, n_edges + 1);
  const Eigen::VectorXd widths = radii.tail(n_edges) - radii.head(n_edges);
  const Eigen::VectorXd roots = factor.transpose() * stress.head(n);
  return roots.tail(n_edges).cwiseQuotient(widths.cwiseSqrt());
}

/// Ratio of the intensities of traction and pressure at the effective edge of the n innermost rings: the parabola
/// through three edges, continued by half a ring.
double ratio_of_intensities(const LadderMesh& mesh, const Eigen::VectorXd& traction, const Eigen::VectorXd& pressure,
                            Index n) {
  const Eigen::VectorXd inverse = edge_intensities(mesh.normal.compliance, pressure, n, 3)
                                      .cwiseQuotient(edge_intensities(mesh.tangential.compliance, traction, n, 3));
  // sqrt(k_x/k_z), Mindlin's ratio of the tangential and the normal stiffness of an incompressible half-space.
  const double mindlin = std::sqrt(2.0 / 3);
  return mindlin / (3.0 / 8 * inverse[0] - 10.0 / 8 * inverse[1] + 15.0 / 8 * inverse[2]);
}

/// Error of the ratio under a profile that is worn outside c.
double worn_edge_error(const LadderMesh& mesh, const mdr::Profile& unworn, const mdr::Profile& exact, double c) {
  const auto& compliance = mesh.tangential.compliance;
  // Half way between the indentations at which the edge touches and at which the worn flank does.
  const double indentation = (mdr::transform(unworn, c) + 1) / 2;
  const auto worn = mdr::limiting_profile(unworn, c, 1);
  const auto means = fem::ring_means(mesh.normal.compliance, [&](double r) { return mdr::shape(worn, r); });
  const auto pressure = fem::normal_contact(mesh.normal, means, indentation).pressure;
  const auto n = static_cast<Index>(std::lround(c * mesh.n_rings));
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

LadderRow worn_edge_row(const std::vector<LadderMesh>& meshes, const mdr::Profile& unworn, const mdr::Profile& exact) {
  const auto error = [&](const LadderMesh& mesh) {
    double worst = 0;
    for (const double c : {0.5, 0.625, 0.75, 0.875}) take_worst(worst, worn_edge_error(mesh, unworn, exact, c));
    return worst;
  };
  return mesh_row("worn contact", "ratio of edge intensities", "paper, equations (9), (13)", meshes,
                  {5e-6, 3, far_field, std::nullopt, "edge at the effective radius"}, error);
}

std::vector<LadderRow> exact_rows() {
  const auto meshes = half_space_ladder({16, 32, 64, 128});
  const auto body = mdr::standard_solid(1, 2, 0.4);
  const std::string field = "floor: far field", rings = "constant pressure on rings: h^2";
  std::vector<LadderRow> rows;
  const auto add = [&](const std::vector<LadderRow>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
  add(indentation_rows(meshes, exact_indentation("Hertz", "Hertz 1882, Johnson 1985", 2),
                       {1e-6, 3, far_field, 1e-6, field}, {1.5e-4, 2, far_field, 1e-5, rings}));
  add(indentation_rows(meshes, exact_indentation("cone", "Love 1939, Sneddon 1965", 1),
                       {1e-6, 3, far_field, 1e-6, field}, {1.5e-4, 2, far_field, 1e-5, rings}));
  add(indentation_rows(meshes, exact_indentation("power law n = 4", "Galin 1946, Sneddon 1965", 4),
                       {3e-6, 3, far_field, 1e-6, field + "; third order with a larger constant"},
                       {3e-4, 2, far_field, 1e-5, rings}));
  add(punch_rows(meshes, exact_punch()));
  add(sliding_rows(meshes, exact_sliding()));
  add({cycle_row(meshes, exact_sliding()), worn_edge_row(meshes, mdr::parabola(1), mdr::parabola(1)),
       step_row(meshes.front(), body, body), growing_contact_time_row(meshes.front(), body, body),
       growing_contact_mesh_row(meshes, body, body)});
  return rows;
}

}  // namespace fretval
