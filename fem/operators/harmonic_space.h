#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "fem/operators/grid_data.h"
#include "fem/operators/harmonic.h"

namespace fretval::fem {

struct HarmonicSpaceParts;  // deal.II objects; see harmonic_space_parts.h

/// The contact line z = 0, split into the elements (rings) that carry a piecewise constant pressure or traction.
struct ContactLine {
  std::vector<double> radii;   ///< n_elements + 1 ring radii, increasing from 0
  Eigen::VectorXd areas;       ///< ring areas, pi (r_{i+1}^2 - r_i^2)
  std::vector<unsigned> dofs;  ///< degrees of freedom of the contact unknown on the line, by increasing radius
  Eigen::MatrixXd loads;       ///< n_dofs x n_elements: nodal forces of a unit traction on each ring

  [[nodiscard]] Eigen::Index n_elements() const { return areas.size(); }
};

/// Taylor-Hood space (Q_k displacement, continuous Q_{k-1} pressure) of one harmonic on the half-plane.
///
/// Unknowns: n = 0: (U, W, P). n = 1: (s, m, W, P) with s = (U - V)/2, m = (U + V)/2, so that the conditions on the
/// axis r = 0 are plain Dirichlet ones: n = 0: U = 0; n = 1: m = W = P = 0. The contact unknown is W (n = 0) or s (n =
/// 1), the angular mean of u_x, work-conjugate to a unidirectional traction tau(r) e_x. The rotation left free by the
/// far-field condition for n = 1 is removed by one W value at the far end of the surface.
///
/// The dofs of the nodes inside cells are the last ones. The others, on corners and edges, are the skeleton.
class HarmonicSpace {
 public:
  /// degree: of the displacement, 2 (Q2/Q1) or more. Throws std::invalid_argument for a lower one or a grid without
  /// contact or far edges.
  HarmonicSpace(const GridData& grid, Harmonic harmonic, unsigned degree);
  ~HarmonicSpace();
  HarmonicSpace(HarmonicSpace&&) noexcept;

  [[nodiscard]] const HarmonicSpaceParts& parts() const { return *parts_; }
  [[nodiscard]] Harmonic harmonic() const { return harmonic_; }
  [[nodiscard]] const ContactLine& contact_line() const { return contact_line_; }
  [[nodiscard]] unsigned n_dofs() const;
  [[nodiscard]] unsigned n_skeleton_dofs() const { return n_skeleton_dofs_; }

 private:
  std::unique_ptr<HarmonicSpaceParts> parts_;
  Harmonic harmonic_;
  unsigned n_skeleton_dofs_ = 0;
  ContactLine contact_line_;
};

}  // namespace fretval::fem
