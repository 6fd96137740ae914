#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/operators/fourier_order.h"

namespace fretval::fem {

/// Mirror symmetries of the contact, by which some of the angles can be left out. About the x axis t_x and p are even
/// and t_y is odd: motion along x, with or without coupling. About both axes: motion along x without coupling, in which
/// p has no part.
enum class Mirrors { none, x, x_and_y };

/// Equally spaced angles `theta_j = (j + 1/2) 2 pi/n` around the axis, so that none lies on a mirror.
struct AngularGrid {
  unsigned n_around;
  Mirrors mirrors;
  Eigen::VectorXd angles;  ///< those that are kept, rising from the first one

  [[nodiscard]] Eigen::Index n_kept() const { return angles.size(); }
  /// Number of points around the axis that each kept point stands for.
  [[nodiscard]] double multiplicity() const { return n_around / static_cast<double>(angles.size()); }
  /// Highest Fourier order of the displacement that fields on these angles draw on.
  [[nodiscard]] unsigned highest_order() const { return n_around / 2 + 1; }
};

/// Throws std::invalid_argument for no angles, and for mirrors that do not map them onto each other: one asks for an
/// even number of angles, two for a multiple of four.
AngularGrid angular_grid(unsigned n_around, Mirrors mirrors = Mirrors::none);

/// A point of the whole circle, and the kept angle whose values it has, with t_y multiplied by sign_of_y.
struct MirroredAngle {
  double angle;
  Eigen::Index kept;
  double sign_of_y;
};
/// All n_around points of the circle, from the first angle on.
std::vector<MirroredAngle> whole_circle(const AngularGrid& grid);

/// A field on the angles: t_x before t_y, or p.
enum class SurfaceField { tangential, normal };

/// An amplitude of a field: a component of a Fourier order (fem/operators/fourier_order.h), and the weights of the
/// values at the kept angles in it.
struct Amplitude {
  FourierOrder order;
  unsigned component;
  Eigen::VectorXd weights;
};

/// Amplitudes of the trigonometric polynomials of least degree through values on the angles: those that are symmetric
/// about the x axis before the others, among each of them those that are symmetric about the y axis before the others,
/// and among these by order and component. With u_x + i u_y = e^{i theta} sum_k c_k e^{i k theta} and the even and odd
/// parts e and o of an order n,
///
///   c_n = m_e - i m_o,    c_{-n} = s_e + i s_o,    c_0 = U - i V,
///
/// so the Cartesian harmonic l = k + 1 of n angles, |l| <= n/2, draws on s of order 1 - l and m of order l - 1. A
/// pressure pushes into the body, against W. Of the two harmonics n/2 of an even number of angles only cos(n/2 (theta -
/// theta_0)) occurs, which is largest on the angles; the other one vanishes there. Amplitudes that vanish by a mirror
/// are left out.
std::vector<Amplitude> amplitudes_of(const AngularGrid& grid, SurfaceField field);

}  // namespace fretval::fem
