#pragma once

#include <array>
#include <functional>

#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// Displacement, pressure and stress of a harmonic at a point (r, z): the amplitudes U, V, W, P and those of the
/// stress.
struct StokesState {
  double u, v, w, pressure;
  std::array<std::array<double, 2>, 3> stress;  ///< components r, theta, z on the faces of normal r and z
};

/// An incompressible body of unit shear modulus in equilibrium without body forces, over (r, z).
using StokesField = std::function<StokesState(double r, double z)>;

/// Kelvin's solution for a unit force in an infinite body, at the height above the surface, along z (normal harmonic)
/// or x (tangential):
///   `u = [F/R + x (x.F)/R^3] / (8 pi)`,   `P = x.F / (4 pi R^3)`,   `sigma = -3 x x (x.F) / (4 pi R^5)`,
/// x counted from the point of the force, R = |x|. Smooth in the body z <= 0 for a positive height. Source: Thomson
/// (Lord Kelvin) 1848; Johnson, Contact Mechanics (1985), section 3.2, at nu = 1/2.
StokesField point_force(const FourierOrder& order, double height);

/// Errors in the L2 norm over the whole body, relative to the norm of the exact field.
struct BulkError {
  double displacement, pressure;
};

/// Errors of the finite elements under the tractions of a field on the contact line, on the free surface and on the far
/// boundary, where its share of the far-field condition is added. Displacements of the tangential harmonic are compared
/// up to a rotation, which the pin of HarmonicSpace chooses. load: the field whose tractions act; exact: the field to
/// compare with, normally the same. Throws SolverError.
BulkError bulk_error(const HarmonicSpace& space, const StokesField& load, const StokesField& exact);

}  // namespace fretval::fem
