#pragma once

namespace fretval {

/// Units that make a case dimensionless: lengths along the surface, depths, shear modulus, angular frequency.
/// The problem is linear in the depths, so they have a unit of their own and the same case in nm and in m agrees to
/// roundoff.
struct Units {
  /// m, the unworn contact radius at the largest indentation; of a profile whose rings touch in any order, the radius
  /// beyond which the indenter is higher than that, which bounds the contact.
  double length;
  double depth;              ///< m, the largest indentation, see deepest_indentation
  double modulus;            ///< Pa, relaxed
  double angular_frequency;  ///< rad/s, of the cycle with which the motion repeats

  [[nodiscard]] double pressure() const { return modulus * depth / length; }
  [[nodiscard]] double force() const { return modulus * depth * length; }
  [[nodiscard]] double volume() const { return length * length * depth; }
};

}  // namespace fretval
