#pragma once

#include <Eigen/Dense>
#include <functional>
#include <string>
#include <vector>

#include "comparison/verification/exact/convergence_rows.h"
#include "fem/history/box_solver.h"
#include "fem/history/friction_force.h"
#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/history/relaxation.h"
#include "fem/history/static_contact.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"

namespace fretval {

// What the rows of the suite `exact` share. For exact_*_rows.cc alone.

constexpr double friction_coefficient = 0.4;
constexpr int n_positions = 193;

/// What cutting the half-space off at 25 contact radii leaves of the errors of radii and forces.
constexpr double far_field = 1e-7;

/// Why some forces end in the first order.
constexpr const char* edges_note = "discs of n rings are 0.0025 rings larger tangentially than normally";

/// What the elements under the rings leave of forces that the rings themselves read better.
constexpr double bulk_floor = 1e-6;
constexpr const char* bulk_note = "floor: elements under the rings";
constexpr const char* far_field_note = "floor: far field";

/// The half-space with n_rings per unit of length, on a contact line of length 1.125.
struct ConvergenceMesh {
  int n_rings;
  fem::ContactProblem normal, tangential;
};

/// n_rings: multiples of 8, so that r = 1 is a node. Throws meshes::MeshError, fem::SolverError.
std::vector<ConvergenceMesh> half_space_meshes(const std::vector<int>& n_rings);

/// Position k of n_positions between two ends.
double position(int k, double first, double last);

/// Largest absolute value, NaN if any is.
void take_worst(double& worst, double error);

Eigen::VectorXd means_of(const mdr::Profile& profile, const fem::ContactProblem& problem);

/// Rows over meshes that come from one pass over each of them. rows: without resolutions and errors; errors: of a mesh,
/// one for each row.
template <class Mesh, class Errors>
std::vector<ConvergenceRow> mesh_rows(std::vector<ConvergenceRow> rows, const std::vector<Mesh>& meshes,
                                      const Errors& errors) {
  for (const auto& mesh : meshes) {
    const std::vector<double> of_mesh = errors(mesh);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].resolutions.push_back(mesh.n_rings);
      rows[i].errors.push_back(of_mesh.at(i));
    }
  }
  return rows;
}

/// A single one.
ConvergenceRow mesh_row(const ConvergenceRow& row, const std::vector<ConvergenceMesh>& meshes,
                        const std::function<double(const ConvergenceMesh&)>& error);

/// A row over numbers of time steps.
ConvergenceRow time_row(ConvergenceRow row, const std::vector<int>& n_steps, const std::function<double(int)>& error);

/// Limit of the tractions, and of their force.
struct FrictionLimit {
  Eigen::VectorXd rings;  ///< mu p
  double force;           ///< mu times the normal force
  double contact_radius;
};

/// Under a profile at an indentation.
FrictionLimit friction_limit(const ConvergenceMesh& mesh, const mdr::Profile& profile, double indentation);

/// Coulomb friction on an elastic body, from rest, one box problem a step: exact in time as long as the contact does
/// not grow within a step and no ring slips back and forth within one.
class ElasticSliding {
 public:
  explicit ElasticSliding(const ConvergenceMesh& mesh);

  /// Traction after a step to a displacement of the indenter; limit: at its end.
  const Eigen::VectorXd& step(double displacement, const FrictionLimit& limit);

  [[nodiscard]] double force() const;
  /// Of the last step, under forward slip.
  [[nodiscard]] double stick_radius() const;

 private:
  const fem::ContactProblem& problem_;
  fem::TouchingRings touching_;
  Eigen::VectorXd slip_, traction_, limit_;
  double limit_force_ = 0;
  std::vector<fem::BoxState> states_;
  fem::SlipZones zones_;
};

using Path = std::function<fem::ValueAndRate(double)>;

fem::RelaxationModel fem_model(const mdr::PronyBody& body);

/// What the finite elements get in the rows in time; the exact solutions are handed theirs.
mdr::PronyBody viscoelastic_body();

/// The force of an indenter that is pressed into a viscoelastic body.
struct PressingForce {
  double time, value;  ///< time: at which forces are balanced
  double sum;          ///< over the rings, which the springs of the same rings reproduce exactly
};

/// Forces in the intervals between the instants, from rest along a path. profile: ring means. Throws SolverError when
/// the contact reaches the end of the contact line.
std::vector<PressingForce> press(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, const Path& path,
                                 const std::vector<double>& instants);

/// What they are off from an exact force over time, once t > 0.3.
struct PressingError {
  double largest_error, largest_exact;
};
PressingError pressing_error(const std::vector<PressingForce>& forces, double PressingForce::*kind,
                             const std::function<double(double)>& exact);

/// 0, first, and n equal steps up to the end.
std::vector<double> instants(double first, double end, int n);

/// A unit step of the indentation, but for a rise this short: a step to a relative 1e-9/tau. Its rate is quadratic, as
/// the scheme takes it.
constexpr double step_rise = 1e-9;
fem::ValueAndRate unit_step(double t);

}  // namespace fretval
