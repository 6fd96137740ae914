#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/ladder.h"
#include "fem/normal_history.h"
#include "mdr/profile.h"
#include "mdr/prony_body.h"

namespace fretval {

/// The verification ladder: finite elements against exact solutions, on meshes that are refined.
/// Dimensionless: unit shear modulus, and a contact radius of 1 at the indentation 1.

/// The half-space with n_rings per unit of length, on a contact line of length 1.125.
struct LadderMesh {
  int n_rings;
  fem::ContactProblem normal, tangential;
};

/// n_rings: multiples of 8, so that r = 1 is a node. Throws meshes::MeshError, fem::SolverError.
std::vector<LadderMesh> half_space_ladder(const std::vector<int>& n_rings);

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
std::vector<LadderRow> indentation_rows(const std::vector<LadderMesh>& meshes, const ExactIndentation& exact,
                                        const LadderDemand& radius, const LadderDemand& force);

/// Forces of a unit displacement of a disc of radius 1: normal, without friction, and tangential, sticking.
struct ExactPunch {
  double normal, tangential;
};

/// `8 G a` and `(16/3) G a`, the springs of mdr/spring_energy.h under a flat face.
ExactPunch exact_punch();

/// Flat punch and full stick: force of the rings inside r = 1 for their nominal and for their effective radius
/// (fem/edge.h).
std::vector<LadderRow> punch_rows(const std::vector<LadderMesh>& meshes, const ExactPunch& exact);

/// What an exact solution says about the parabola at the indentation 1, over the tangential displacement.
struct ExactSliding {
  std::function<double(double)> stick_radius, force;
};

/// Cattaneo and Mindlin, as in mdr/indentation.h.
ExactSliding exact_sliding();

/// Stick radius, relative to the contact radius, and force, for stick radii from 0.3 to 0.9.
std::vector<LadderRow> sliding_rows(const std::vector<LadderMesh>& meshes, const ExactSliding& exact);

/// Energy that a cycle between +-u_x dissipates, from the force-displacement curve of the first loading by Masing's
/// rule: `W = 8 int_0^u F du - 4 u F(u)`; u_x from 0.3 to 0.9 of what makes the whole contact slide.
LadderRow cycle_row(const std::vector<LadderMesh>& meshes, const ExactSliding& exact);

/// Ratio of the intensities of traction and pressure at the edge of a fully worn contact at the limit of sticking:
/// mu. unworn is what the finite elements get, exact what the solution takes, the same unless a test tampers.
LadderRow worn_edge_row(const std::vector<LadderMesh>& meshes, const mdr::Profile& unworn, const mdr::Profile& exact);

// Rows in time: body is what the finite elements get, exact what the solution takes, the same unless a test tampers.

/// The force of a flat punch after a step, over its elastic force on the same rings, `G(t)/G0`. The scheme integrates
/// it exactly in time.
LadderRow step_row(const LadderMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact);

/// The force of a parabola pressed in at a constant rate, while the contact grows: over the number of steps, against
/// Lee and Radok's integral of the elastic force of the same rings, and over the mesh, of the exact one.
LadderRow growing_contact_time_row(const LadderMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact);
LadderRow growing_contact_mesh_row(const std::vector<LadderMesh>& meshes, const mdr::PronyBody& body,
                                   const mdr::PronyBody& exact);

/// Every row, on 16, 32, 64 and 128 rings per contact radius.
std::vector<LadderRow> exact_rows();

}  // namespace fretval
