#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Tractions of the rings as a superposition of flat punches: the disc of rings 0..j stands under a punch displaced by
/// D_j - D_{j+1} more than the next larger one. With the Cholesky factor C = L L^T of the compliance and b = L^{-1} A
/// (b_j^2 is what ring j adds to the force of a unit punch), the depths of a traction t are `D_j = (L^T t)_j / b_j`,
/// and its force is `A.t = sum_j b_j^2 D_j`, exactly.
///
/// That sum is the midpoint rule for `k int D(r) dr`, k the force of a unit punch per radius, with D_j at
/// EffectiveRadii::of_rings (fem/ring_contact/effective_radii.h). D(r) is smooth but for kinks where a
/// zone ends, in the middle of a ring; there the sum is off by the second order of the ring. The integrals below follow
/// the cubics of either side up to their intersection instead (subcell resolution, Harten 1989), which is of third
/// order: 2e-7 for the Hertz force at 64 rings, where the sum gives 9e-5. Everything here comes from the compliance.
///
/// On another body than a half-space F(r), the force of a unit punch, is not in proportion to its radius, and the sum
/// stands for `int D dF(r)`. Integrals are taken over x = F/k then, in which D is as smooth, with k = F/r of a small
/// punch.
class PunchSeries {
 public:
  /// factor: lower Cholesky factor of the compliance; inverse: of that.
  PunchSeries(const Compliance& compliance, SharedMatrix factor, SharedMatrix inverse);

  /// The same with its depths at other radii, of which there is one for each ring.
  [[nodiscard]] PunchSeries with_depths_at(Eigen::VectorXd radii) const;

  /// D_j of ring tractions, one column each.
  ///
  /// Of a stick margin mu p - |tau| they are the slip reserves: how far the indenter could move on tangentially before
  /// a ring slips. The margin is a traction on the stuck rings like the pressure under a punch; it falls by the
  /// traction of a unit punch per displacement, ring after ring from the outside. A reserve is to the margin what a
  /// spring of MDR is to the pressure: it varies smoothly in time also next to the edge, where the margin falls and
  /// rises like |t - t*|, so it is the reserve whose minimum over time can be read from samples.
  [[nodiscard]] Eigen::VectorXd depths(Eigen::VectorXd traction) const;
  void to_depths(Eigen::VectorXd& traction) const;                                    ///< in its place
  [[nodiscard]] Eigen::MatrixXd depths_of_instants(Eigen::MatrixXd tractions) const;  ///< a column each

  /// The same from L^T t, which whoever has solved for t has already.
  template <class Loads>
  [[nodiscard]] auto depths_of_loads(const Eigen::MatrixBase<Loads>& loads) const {
    return loads.cwiseProduct(per_load_);
  }
  /// The other way round. Of displacements as below, `L^{-1} (A s)`.
  [[nodiscard]] auto loads_of_depths(const Eigen::VectorXd& depths) const { return depths.cwiseProduct(by_load_); }

  /// Ring tractions of depths.
  [[nodiscard]] Eigen::VectorXd tractions(const Eigen::VectorXd& depths) const;
  /// That a depth gives its own ring.
  [[nodiscard]] double own_traction(Eigen::Index i) const { return by_load_[i] / (*factor_)(i, i); }

  /// `s_j = (L^{-1} (A s))_j / b_j` of ring displacements s: work-conjugate to the depths,
  /// `sum_j A_j t_j s_j = sum_j b_j^2 D_j s_j`. Those of an elastic body are its depths. Of a gap they are smooth up to
  /// the edge of the contact, whatever pressure there is.
  [[nodiscard]] Eigen::VectorXd displacements(Eigen::VectorXd rings) const;
  void to_displacements(Eigen::Ref<Eigen::VectorXd> rings) const;  ///< in their place

  /// The other way round: ring displacements in the place of such ones, for a range of rings inside which they vanish.
  void to_rings(Eigen::Ref<Eigen::VectorXd> displacements, Eigen::Index first = 0) const;

  /// An integral over the punches, and what it leaves open where it is the plain sum at the end of a zone: a kink
  /// inside a ring puts the midpoint rule off by an eighth of the second difference of D times the width of the ring at
  /// most.
  struct Integral {
    double value, unseen_kinks;
  };

  /// `k int D dr` for depths, or products of depths and displacements, of the innermost rings. zones: a label per ring,
  /// of these rings; D may have a kink or a jump where neighbouring labels differ. Next to zones of a single ring, and
  /// where the two sides do not meet between their rings (as with a dashpot, whose pressure jumps at the edge), it is
  /// the plain sum. end: where D ends, if not with the last ring; beyond the last ring D is continued up to there.
  [[nodiscard]] Integral integral(const Eigen::VectorXd& depths, const std::vector<signed char>& zones,
                                  std::optional<double> end = std::nullopt) const;
  /// The same of the n innermost rings, in two zones: those before n_inner, and the others.
  [[nodiscard]] Integral integral(const Eigen::VectorXd& depths, Eigen::Index n_inner, Eigen::Index n,
                                  std::optional<double> end = std::nullopt) const;

  /// Radius at which the pressure of n_pressed rings vanishes; empty if their contact does not end there.
  [[nodiscard]] std::optional<double> edge_of_pressure(const Eigen::VectorXd& depths, Eigen::Index n_pressed) const;

  /// k, of a unit punch; on another body than a half-space that of a small one.
  [[nodiscard]] double force_per_radius() const { return force_per_radius_; }
  [[nodiscard]] const Eigen::VectorXd& areas() const { return areas_; }
  /// Radii that the depths belong to.
  [[nodiscard]] const Eigen::VectorXd& radii() const { return radii_; }
  /// Effective radius of the n innermost rings, n = 0..n_rings.
  [[nodiscard]] const Eigen::VectorXd& edges() const { return edges_; }
  /// Force of a unit punch of the n innermost rings.
  [[nodiscard]] double punch_force(Eigen::Index n) const { return force_per_radius_ * places_.edges[n]; }
  /// Where the depths of rings lie in the coordinate over which they are integrated, F/k (see above).
  [[nodiscard]] const Eigen::VectorXd& places() const { return places_.depths; }
  /// Of a radius.
  [[nodiscard]] double place_of(double radius) const;
  /// Whether the force of a punch is in proportion to its radius.
  [[nodiscard]] bool is_half_space() const { return half_space_; }

 private:
  void put_depths_at(Eigen::VectorXd radii);

  template <class Label>
  [[nodiscard]] Integral integral_of(const Eigen::VectorXd& depths, const Label& label, Eigen::Index n,
                                     std::optional<double> end) const;

  SharedMatrix factor_, inverse_;
  Eigen::VectorXd areas_;
  Eigen::VectorXd by_load_, per_load_;  // b, 1/b
  Eigen::VectorXd edges_;               // n + 1 effective radii
  bool half_space_;
  /// Of edges and depths, over which integrals are taken: x.
  struct Places {
    Eigen::VectorXd edges, depths;
  };
  Places places_;
  Eigen::VectorXd radii_;         // of the depths
  Eigen::Matrix4Xd whole_rings_;  // integral over ring i of the cubic through i - 1 to i + 2, per depth
  double force_per_radius_;
};

}  // namespace fretval::fem
