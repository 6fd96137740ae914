#pragma once

#include <tuple>

namespace fretval::fem {

/// How the displacement of a Fourier order depends on the angle theta:
///   even: u_r = U cos(n theta), u_theta = V sin(n theta), u_z = W cos(n theta);
///   odd:  u_r = U sin(n theta), u_theta = -V cos(n theta), u_z = W sin(n theta).
/// For n >= 1 the odd field is the even one turned by 90 degrees / n, so that both have the same operators. For n = 0
/// the even field is the axisymmetric one without twist, (U, W), and the odd one is torsion, V alone.
enum class Parity { even, odd };

/// One Fourier order of the displacement around the axis.
struct FourierOrder {
  unsigned n = 0;
  Parity parity = Parity::even;

  [[nodiscard]] constexpr bool is_torsion() const { return n == 0 && parity == Parity::odd; }
};

/// The order of the displacement by a motion along the axis, and by one along x.
constexpr FourierOrder axisymmetric{0, Parity::even}, lateral{1, Parity::even};

constexpr bool operator==(const FourierOrder& a, const FourierOrder& b) {
  return a.n == b.n && a.parity == b.parity;
}
inline bool operator<(const FourierOrder& a, const FourierOrder& b) {
  return std::tie(a.n, a.parity) < std::tie(b.n, b.parity);
}

// Unknowns of an order, one finite element component each: (U, W) for n = 0, V for torsion, and (s, m, W) with
// s = (U - V)/2, m = (U + V)/2 for n >= 1, in terms of which the conditions on the axis are plain Dirichlet ones.

/// Number of displacement components. The component of the pressure follows them, except in torsion, which changes no
/// volume.
constexpr unsigned n_displacements(const FourierOrder& order) {
  if (order.n > 0) return 3;
  return order.is_torsion() ? 1 : 2;
}
constexpr bool has_pressure(const FourierOrder& order) {
  return !order.is_torsion();
}

/// Index of the vertical displacement W, which torsion does not have.
constexpr unsigned vertical_component(const FourierOrder& order) {
  return n_displacements(order) - 1;
}

/// Index of the unknown of the ring contact: W (n = 0), V (torsion) or s, which for n = 1 is the angular mean of u_x.
constexpr unsigned ring_component(const FourierOrder& order) {
  return order == axisymmetric ? 1 : 0;
}

}  // namespace fretval::fem
