#pragma once

namespace fretval::mdr {

/// How a layer rests on its rigid base.
enum class LayerBase {
  bonded,
  frictionless  ///< nothing holds such a layer against tangential motion
};

/// Elastic or viscoelastic layer on a rigid base. All of its moduli share one G(t), so that Poisson's ratio is a
/// constant.
struct Layer {
  double thickness;            ///< H in m, positive; infinity: a half-space, whose springs are independent
  double poisson_ratio = 0.5;  ///< nu, 0 to 0.5
  LayerBase base = LayerBase::bonded;
};

/// Throws std::invalid_argument unless the layer is as described above.
void validate(const Layer& layer);

/// The two directions of the surface. Tangentially the traction keeps one direction, and the displacement is the
/// angular mean of u_x, as MDR has both.
enum class Direction { normal, tangential };

/// E*/G = 2/(1-nu) and G*/G = 4/(2-nu), by which a spring of a half-space bears E* w or G* w per length. 4 and 8/3 at
/// nu = 1/2. Source: Popov and Hess, Method of Dimensionality Reduction (2015), chapters 3 and 5. nu from 0 to 0.5,
/// otherwise std::invalid_argument.
double spring_modulus(Direction direction, double poisson_ratio);

/// E*/G* = (2-nu)/(2(1-nu)): how far a tangential spring moves under mu q, over mu times its depth; 3/2 at nu = 1/2.
double spring_modulus_ratio(double poisson_ratio);

}  // namespace fretval::mdr
