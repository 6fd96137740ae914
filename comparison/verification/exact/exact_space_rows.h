#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/verification/exact/exact_parts.h"
#include "mdr/profiles/profile.h"

namespace fretval {

/// Rows of the suite `exact`: finite elements against exact solutions, on meshes that are refined.
/// Dimensionless: unit shear modulus, and a contact radius of 1 at the indentation 1.

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
/// mu. unworn is what the finite elements get, exact what the solution takes, the same unless a test tampers.
ConvergenceRow worn_edge_row(const std::vector<ConvergenceMesh>& meshes, const mdr::Profile& unworn,
                             const mdr::Profile& exact);

/// A parabola pressed in to `first`, then moved on obliquely: du_x/dd below the slope at which the contact slides up to
/// `second`, above it up to `last`.
struct ObliqueLoading {
  double first, second, last;
  double sticking_slope, slipping_slope;
};
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
std::vector<ConvergenceRow> oblique_rows(const std::vector<ConvergenceMesh>& meshes, const ObliqueLoading& loading,
                                         const ExactOblique& exact);

}  // namespace fretval
