#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "fem/operators/fourier_order.h"
#include "fem/operators/grid_data.h"

namespace fretval::fem {

struct HarmonicSpaceParts;  // deal.II objects; see harmonic_space_parts.h

/// The contact line z = 0, split into the elements (rings) that carry a piecewise constant pressure or traction, in one
/// component of the displacement or in several, one after the other.
struct ContactLine {
  std::vector<double> radii;   ///< n_elements + 1 ring radii, increasing from 0
  Eigen::VectorXd areas;       ///< ring areas, pi (r_{i+1}^2 - r_i^2)
  std::vector<unsigned> dofs;  ///< unconstrained dofs on the line, component by component, by increasing radius
  /// n_dofs x (n_components n_elements): nodal forces of a unit traction on each ring. For s and m the traction is a
  /// unit vector everywhere, so that their forces are `2 pi int N r dr`, like all forces of n = 0; a pressure cos(n
  /// theta), n >= 1, has half of that.
  Eigen::MatrixXd loads;

  [[nodiscard]] Eigen::Index n_elements() const { return areas.size(); }
};

/// Taylor-Hood space (Q_k displacement, continuous Q_{k-1} pressure) of one Fourier order on the half-plane, with the
/// unknowns of fourier_order.h and P.
///
/// On the axis r = 0: U = 0 (n = 0), V = 0 (torsion), m = W = P = 0 (n = 1), and all of them vanish for n >= 2. The
/// unknown of the ring contact is W (n = 0) or s (n = 1), the angular mean of u_x, work-conjugate to a unidirectional
/// traction tau(r) e_x. The rotation left free by the far-field condition for n = 1 is removed by one W value at the
/// far end of the surface, unless the body is bonded somewhere.
///
/// The dofs of the nodes inside cells are the last ones. The others, on corners and edges, are the skeleton.
class HarmonicSpace {
 public:
  /// degree: of the displacement, 2 (Q2/Q1) or more. Throws std::invalid_argument for a lower one, for a grid without
  /// contact edges, for one that nothing holds against the rigid motions of this order, for Poisson's ratios outside 0
  /// to 0.5 and moduli that are not positive or not one for each cell.
  HarmonicSpace(const GridData& grid, const FourierOrder& order, unsigned degree);
  ~HarmonicSpace();
  HarmonicSpace(HarmonicSpace&&) noexcept;

  [[nodiscard]] const HarmonicSpaceParts& parts() const { return *parts_; }
  [[nodiscard]] FourierOrder order() const { return order_; }
  [[nodiscard]] const Elasticity& elasticity() const { return elasticity_; }
  /// The contact line in the component of the ring contact (ring_component).
  [[nodiscard]] const ContactLine& contact_line() const { return contact_line_; }
  /// The contact line in several components, in the order given.
  [[nodiscard]] ContactLine contact_line(const std::vector<unsigned>& components) const;
  [[nodiscard]] unsigned n_dofs() const;
  [[nodiscard]] unsigned n_skeleton_dofs() const { return n_skeleton_dofs_; }

 private:
  std::unique_ptr<HarmonicSpaceParts> parts_;
  FourierOrder order_;
  Elasticity elasticity_;
  unsigned n_skeleton_dofs_ = 0;
  ContactLine contact_line_;
};

}  // namespace fretval::fem
