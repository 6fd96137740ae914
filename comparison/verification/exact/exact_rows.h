#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "comparison/verification/exact/convergence_rows.h"
#include "fem/motion/relaxation.h"
#include "fem/operators/grid_data.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/static_contact.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval {

using Rows = std::vector<ConvergenceRow>;

// Common parts of the rows of the suite `exact`. All is dimensionless: the shear modulus is 1, and the contact radius
// is 1 at the indentation 1.

/// The scene of the exact solutions, which is that of the finite elements. A test passes a different one, and the rows
/// have to fail then.
struct ExactScene {
  double modulus = 1, friction_coefficient = 0.4;
  double steepness = 1;                                  ///< of the indenter, whose shape is multiplied by it
  mdr::PronyBody body = mdr::standard_solid(1, 2, 0.4);  ///< of the rows in time
};

/// The half-space with n_rings per unit of length, on a contact line of length 1.125.
struct ConvergenceMesh {
  int n_rings;
  fem::ContactProblem normal, tangential;
};
using Meshes = std::vector<ConvergenceMesh>;

/// Meshes of the half-space. n_rings: multiples of 8, so that r = 1 is a node. Throws meshes::MeshError,
/// fem::SolverError.
Meshes half_space_meshes(const std::vector<int>& n_rings, double poisson_ratio = 0.5, double far_radius = 25);

/// Radius and force of a contact in the normal direction.
struct RadiusAndForce {
  double radius, force;
};

/// Largest relative errors of contact radius and force of an indenter at some indentations. known: the exact ones of an
/// indentation.
std::vector<double> static_errors(const ConvergenceMesh& mesh, const mdr::Profile& shape,
                                  const std::vector<double>& indentations,
                                  const std::function<RadiusAndForce(double)>& known);

/// Stick radius under forward slip, from the tractions and states of the rings and their friction limit.
double stick_radius_of(const fem::ContactProblem& tangential, const Eigen::VectorXd& limit,
                       const Eigen::VectorXd& traction, const std::vector<fem::BoxState>& states);

/// Stick radius of a push from rest under a normal contact that stays: one box problem.
double stick_radius_of_push(const ConvergenceMesh& mesh, const Eigen::VectorXd& pressure, double displacement);

constexpr int n_positions = 193;
inline const double friction_coefficient = ExactScene().friction_coefficient;

/// Error of radii and forces from cutting the half-space off at 25 contact radii.
constexpr double far_field = 1e-7;
constexpr const char* far_field_note = "floor: far field";

/// Error of forces from the elements under the rings; the reading by the rings is better.
constexpr double bulk_floor = 1e-6;
constexpr const char* bulk_note = "floor: elements under the rings";

/// Position k of n_positions between two ends.
double position(int k, double first, double last);

/// Largest absolute value, NaN if any is.
void take_worst(double& worst, double error);

/// Ring means of a profile, unworn or limiting.
template <class Profile>
Eigen::VectorXd means_of(const Profile& profile, const fem::ContactProblem& problem) {
  return fem::ring_means(problem.compliance, [&](double r) { return mdr::shape(profile, r); });
}

fem::RelaxationModel fem_model(const mdr::PronyBody& body);

void append(Rows& rows, const Rows& more);

/// Rows over meshes that come from one pass over each of them. rows: without resolutions and errors; errors: of a mesh,
/// one for each row.
template <class Mesh, class Errors>
Rows mesh_rows(Rows rows, const std::vector<Mesh>& meshes, const Errors& errors) {
  for (const auto& mesh : meshes) {
    const std::vector<double> of_mesh = errors(mesh);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].resolutions.push_back(mesh.n_rings);
      rows[i].errors.push_back(of_mesh.at(i));
    }
  }
  return rows;
}

/// A single row over meshes.
ConvergenceRow mesh_row(const ConvergenceRow& row, const Meshes& meshes,
                        const std::function<double(const ConvergenceMesh&)>& error);

/// A row over numbers of time steps.
ConvergenceRow time_row(ConvergenceRow row, const std::vector<int>& n_steps, const std::function<double(int)>& error);

/// The suite `exact`: finite elements against exact solutions, on meshes and steps that are refined. Every row, on 16,
/// 32, 64 and 128 rings per contact radius.
Rows exact_rows();

// Rows of the suite `exact` by theme.

/// A mesh of the quarter disc of radius 6 for the fields in the body, n_rings on a contact line of length 1.
struct BulkMesh {
  int n_rings;
  fem::GridData grid;
};

/// A mesh with 4 rings, and n_meshes - 1 refinements of it, each with every cell split into four.
std::vector<BulkMesh> bulk_meshes(int n_meshes);

Rows indentation_rows(const Meshes& meshes, const ExactScene& exact);  ///< Hertz, cone, power law, flat punch, stick
Rows sliding_rows(const Meshes& meshes, const ExactScene& exact);      ///< Cattaneo-Mindlin, unloading, cycle
Rows oblique_rows(const Meshes& meshes, const ExactScene& exact);      ///< Jaeger
Rows worn_edge_rows(const Meshes& meshes, const ExactScene& exact);    ///< the paper's limiting profile
Rows relaxation_rows(const Meshes& meshes, const ExactScene& exact);   ///< steps of the indentation
Rows pressing_rows(const Meshes& meshes, const ExactScene& exact);     ///< Lee-Radok, Ting
Rows periodic_rows(const Meshes& meshes, const ExactScene& exact);     ///< stick radii under the paper's motion
Rows poisson_rows(const std::vector<int>& n_rings, const ExactScene& exact);  ///< compressible half-spaces
Rows layer_rows(const std::vector<int>& n_rings, const ExactScene& exact);    ///< parabolas and punches on layers
Rows bulk_rows(const std::vector<BulkMesh>& meshes, double exact_force);      ///< Kelvin

}  // namespace fretval
