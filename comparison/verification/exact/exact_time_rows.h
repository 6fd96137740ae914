#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/verification/exact/exact_parts.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

// Rows in time: body is what the finite elements get, exact what the solution takes, the same unless a test tampers.

/// The force of a flat punch after a step, over its elastic force on the same rings, `G(t)/G0`. The scheme integrates
/// it exactly in time.
ConvergenceRow step_row(const ConvergenceMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact);

/// The force of a parabola pressed in at a constant rate, while the contact grows: over the number of steps, against
/// Lee and Radok's integral of the elastic force of the same rings, and over the mesh, of the exact one.
ConvergenceRow growing_contact_time_row(const ConvergenceMesh& mesh, const mdr::PronyBody& body,
                                        const mdr::PronyBody& exact);
ConvergenceRow growing_contact_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                                        const mdr::PronyBody& exact);

/// The force of a parabola after a step of the indentation, `G(t)/G0` times Hertz.
ConvergenceRow hertz_step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                              const mdr::PronyBody& exact);

/// The force of a parabola pressed in and pulled out again, d = t (2 - t), until it has left: over the number of steps,
/// against Ting's integral of the elastic force of the same rings, and over the mesh, of the exact one.
ConvergenceRow retraction_time_row(const ConvergenceMesh& mesh, const mdr::PronyBody& body,
                                   const mdr::PronyBody& exact);
ConvergenceRow retraction_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                                   const mdr::PronyBody& exact);

/// A sphere that hits the body: coefficient of restitution and largest force. The finite elements integrate its motion
/// by the trapezoidal rule, the reference is that of comparison/rebound.h.
std::vector<ConvergenceRow> rebound_rows(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                                         const mdr::PronyBody& exact);

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

}  // namespace fretval
