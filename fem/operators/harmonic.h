#pragma once

namespace fretval::fem {

/// Fourier harmonic in the angle theta of the displacement
/// `u_r = U cos(n theta), u_theta = V sin(n theta), u_z = W cos(n theta)`.
enum class Harmonic { normal = 0, tangential = 1 };

}  // namespace fretval::fem
