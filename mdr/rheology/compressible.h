#pragma once

#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// A half-space of any Poisson's ratio as an incompressible one, which all of mdr/ is written for. Where normal and
/// tangential contact are taken as uncoupled, Poisson's ratio is in E* = 2G/(1-nu) and G* = 4G/(2-nu) alone, which are
/// 4G and 8G/3 at nu = 1/2. So a half-space (G, nu) is an incompressible one of the modulus
///
///   G' = G/(2(1-nu)),     whose tangential displacements are     u_x' = stretch u_x,   stretch = 3(1-nu)/(2-nu):
///
/// normal displacements, forces, stresses, stick radii and worn profiles are the same, with all moduli of the body
/// scaled and the prescribed u_x stretched. Tangential displacements and slips of the answer, and the work of
/// tangential forces, are divided by the stretch. A = 2 u_x'/(3 mu) is 2(1-nu)/(2-nu) u_x/mu of the body (G, nu). At nu
/// = 1/2 both factors are 1, to the last bit. Springs of any nu with all their energies, directly: a layer of infinite
/// thickness (mdr/layer/coupled_bed.h).
///
/// Source: Popov and Hess, Method of Dimensionality Reduction (2015), chapters 3 and 5. nu from 0 to 0.5, otherwise
/// std::invalid_argument.
PronyBody incompressible_equivalent(const PronyBody& body, double poisson_ratio);
Rheology incompressible_equivalent(const Rheology& body, double poisson_ratio);

/// 1/(2(1-nu)), by which the moduli are scaled.
double incompressible_modulus_ratio(double poisson_ratio);

/// 3(1-nu)/(2-nu), 1.5 at nu = 0, 1 at nu = 1/2.
double tangential_stretch(double poisson_ratio);

}  // namespace fretval::mdr
