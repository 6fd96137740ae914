#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/verification/exact/exact_parts.h"
#include "fem/full_model/manufactured_solution.h"
#include "fem/operators/grid_data.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

/// The suite `exact`: finite elements against exact solutions, on meshes and steps that are refined. Every row, on 16,
/// 32, 64 and 128 rings per contact radius.
std::vector<ConvergenceRow> exact_rows();

// Its rows. Dimensionless: unit shear modulus, and a contact radius of 1 at the indentation 1. `exact` is the solution
// that the finite elements are held to, or what it takes: a test tampers with it, and the row has to fail.

/// What an exact solution says about an indenter on the elastic half-space, over the indentation. The profile is what
/// the finite elements get.
struct ExactIndentation {
  std::string name, source;
  mdr::Profile profile;
  std::function<double(double)> contact_radius, force;
};

/// `f = b r^n`, b such that the contact radius is 1 at the indentation 1, with the solution of mdr/indentation.h.
ExactIndentation exact_indentation(const std::string& name, const std::string& source, double exponent);

/// Contact radius and force, for contact radii from 0.8 to 1.
std::vector<ConvergenceRow> indentation_rows(const std::vector<ConvergenceMesh>& meshes, const ExactIndentation& exact,
                                             const ConvergenceDemand& radius, const ConvergenceDemand& force);

/// Forces of a unit displacement of a disc of radius 1: normal, without friction, and tangential, sticking.
struct ExactPunch {
  double normal, tangential;
};

/// `8 G a` and `(16/3) G a`, the springs of mdr/spring_energy.h under a flat face.
ExactPunch exact_punch();

/// Flat punch and full stick: force of the rings inside r = 1 for their nominal and for their effective radius
/// (fem/edge.h).
std::vector<ConvergenceRow> punch_rows(const std::vector<ConvergenceMesh>& meshes, const ExactPunch& exact);

/// What an exact solution says about the parabola at the indentation 1, over the tangential displacement.
struct ExactSliding {
  std::function<double(double)> stick_radius, force;
  std::function<double(double)> displacement;  ///< over the force
};

/// Cattaneo and Mindlin, as in mdr/indentation.h; `u = (3 mu/2) [1 - (1 - F_x/(mu F))^(2/3)]`.
ExactSliding exact_sliding();

/// Stick radius, relative to the contact radius, force, and the displacement that belongs to the force computed, for
/// stick radii from 0.3 to 0.9.
std::vector<ConvergenceRow> sliding_rows(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact);

/// Energy that a cycle between +-u_x dissipates, from the force-displacement curve of the first loading by Masing's
/// rule: `W = 8 int_0^u F du - 4 u F(u)`; u_x from 0.3 to 0.9 of what makes the whole contact slide.
ConvergenceRow cycle_row(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact);

/// Force between +u_x and -u_x after the first loading to u_x, relative to the largest: by Masing's rule
/// `F(u_x) - 2 F((u_x - u)/2)`; u_x 0.3, 0.6 and 0.9 of what makes the whole contact slide.
ConvergenceRow unloading_row(const std::vector<ConvergenceMesh>& meshes, const ExactSliding& exact);

/// Ratio of the intensities of traction and pressure at the edge of a fully worn contact at the limit of sticking:
/// mu. exact: the unworn profile.
ConvergenceRow worn_edge_row(const std::vector<ConvergenceMesh>& meshes, const mdr::Profile& exact);

/// A parabola pressed in to `first`, then moved on obliquely: du_x/dd below the slope at which the contact slides up to
/// `second`, above it up to `last`.
struct ObliqueLoading {
  double first, second, last;
  double sticking_slope, slipping_slope;
};
constexpr ObliqueLoading oblique_loading{0.4, 0.8, 0.925, 0.3, 3};
double tangential_displacement(const ObliqueLoading& loading, double indentation);

/// What an exact solution says about it, over the indentation.
struct ExactOblique {
  std::function<double(double)> stick_radius, force;
};

/// Jaeger's superposition of normal contacts. A point that joins the contact while everything sticks moves along from
/// then on; with s = (2/3) du_x/dd of the sticking part, F the normal force and D = g(c) the depth at the stick radius
///   `mu (d - D) = (2/3) u_x - s (max(D, first) - first)`,
///   `F_x = mu [F(d) - F(D)] + s [F(max(D, first)) - F(first)]`;   D = d while everything sticks.
ExactOblique exact_oblique(const ObliqueLoading& loading);

/// Force relative to the largest one, and the stick radius over the contact radius while it is inside the first
/// contact.
std::vector<ConvergenceRow> oblique_rows(const std::vector<ConvergenceMesh>& meshes, const ExactOblique& exact);

// Rows in time; those over the number of steps are computed on the coarsest mesh.

/// The force of a flat punch after a step, over its elastic force on the same rings, `G(t)/G0`. The scheme integrates
/// it exactly in time.
ConvergenceRow step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);

/// The force of a parabola pressed in at a constant rate, while the contact grows: over the number of steps, against
/// Lee and Radok's integral of the elastic force of the same rings, and over the mesh, of the exact one.
ConvergenceRow growing_contact_time_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);
ConvergenceRow growing_contact_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);

/// The force of a parabola after a step of the indentation, `G(t)/G0` times Hertz.
ConvergenceRow hertz_step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);

/// The force of a parabola pressed in and pulled out again, d = t (2 - t), until it has left: over the number of steps,
/// against Ting's integral of the elastic force of the same rings, and over the mesh, of the exact one.
ConvergenceRow retraction_time_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);
ConvergenceRow retraction_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact);

struct TangentialOscillation {
  double amplitude, degrees;  ///< degrees: phase
};

/// Combined oscillation at omega = 1 about the indentation `1 - normal_amplitude`, under a parabola.
struct PeriodicCase {
  std::string name, source;  ///< source: of the shakedown radius
  mdr::PronyBody body;
  double normal_amplitude;
  std::vector<TangentialOscillation> tangential;
  ConvergenceDemand first_slip, shakedown;
};

using ExactStickRadii = std::function<mdr::StickRadii(const mdr::PronyBody&, const mdr::Motion&)>;

/// Both stick radii of mdr/stick_radius.h for the parabola.
ExactStickRadii exact_stick_radii();

/// First-slip and shakedown radius of the periodic state, 120 steps a cycle: the largest error over the
/// tangential motions, over the largest contact radius.
std::vector<ConvergenceRow> periodic_rows(const std::vector<ConvergenceMesh>& meshes, const PeriodicCase& periodic,
                                          const ExactStickRadii& exact);

/// A mesh of the quarter disc of radius 6 for the fields in the body, n_rings on a contact line of length 1.
struct BulkMesh {
  int n_rings;
  fem::GridData grid;
};

/// 4 rings, and each further mesh with every cell split into four.
std::vector<BulkMesh> bulk_meshes(int n_meshes);

struct BulkCase {
  std::string name;
  fem::Harmonic harmonic;
  double displacement_tolerance, pressure_tolerance;  ///< on the finest mesh
};

/// Displacement and pressure in the body under the tractions of a unit force: see fem/manufactured_solution.h.
std::vector<ConvergenceRow> bulk_rows(const std::vector<BulkMesh>& meshes, const BulkCase& bulk,
                                      const fem::StokesField& exact);

}  // namespace fretval
