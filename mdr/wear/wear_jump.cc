#include "mdr/wear/wear_jump.h"

#include <Eigen/LU>
#include <algorithm>

namespace fretval::mdr {

namespace {

constexpr int most_iterations = 60;

// The rings that slip, from the innermost one outwards, and the springs under them. Springs further inside keep their
// load, and do not bear on these rings.
class Jump {
 public:
  Jump(const AbelMatrices& matrices, const WearCycle& cycle, const Eigen::ArrayXd& room, Eigen::Index inner,
       double accuracy)
      : n_(matrices.image.rows() - inner),
        image_(matrices.image.bottomRightCorner(n_, n_)),
        stress_(matrices.stress.bottomRightCorner(n_, n_)),
        path_(cycle.path.bottomRows(n_)),
        load_(cycle.load.bottomRows(n_)),
        stiffness_(Eigen::MatrixXd::Ones(n_, cycle.load.cols())),
        accuracy_(accuracy) {
    for (Eigen::Index j = 0; j < n_; ++j) {
      const double r = room[inner + j];
      if (r > 0)
        stiffness_.row(j) = (load_.row(j) / r).cwiseMax(1);
      else
        load_.row(j) = load_.row(j).cwiseMin(0);
    }
  }

  [[nodiscard]] std::optional<Eigen::ArrayXd> worn(double work) const {
    Eigen::VectorXd worn = Eigen::VectorXd::Zero(n_);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const Eigen::VectorXd correction = newton_correction(worn, work);
      worn += correction;
      if (correction.cwiseAbs().maxCoeff() <= accuracy_) return worn.array().max(0);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Eigen::VectorXd newton_correction(const Eigen::VectorXd& worn, double work) const {
    const Eigen::VectorXd fall = image_.triangularView<Eigen::Lower>() * worn;
    const Eigen::MatrixXd load = load_ - fall.asDiagonal() * stiffness_;
    // After many cycles the loads that are left are below roundoff, so that springs which have only just parted still
    // count as loaded, and relieved by wear.
    const Eigen::MatrixXd relieved = (load.array() > -accuracy_).select(stiffness_, 0);
    const Eigen::VectorXd wear = work * stress_of(load.cwiseMax(0)).rowwise().sum();
    Eigen::MatrixXd system = work * (stress_of(relieved) * image_.triangularView<Eigen::Lower>());
    system.diagonal().array() += 1;
    Eigen::VectorXd residual = wear - worn;
    // A ring wears unless its own equation alone would heal it: the residual is taken over its slope, as after many
    // cycles the residual itself is roundoff of any sign.
    for (Eigen::Index i = 0; i < n_; ++i) {
      if (residual[i] + worn[i] * system(i, i) > 0) continue;
      system.row(i).setZero();
      system(i, i) = 1;
      residual[i] = -worn[i];
    }
    return system.partialPivLu().solve(residual);
  }

  // Stress of each spring on each ring times the path of the ring, over all instants; only springs further out count.
  [[nodiscard]] Eigen::MatrixXd stress_of(const Eigen::MatrixXd& load) const {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(n_, n_);
    product.triangularView<Eigen::Upper>() = path_ * load.transpose();
    return stress_.cwiseProduct(product);
  }

  Eigen::Index n_;
  Eigen::MatrixXd image_, stress_, path_, load_, stiffness_;
  double accuracy_;  // m
};

}  // namespace

std::optional<Eigen::ArrayXd> wear_jump(const AbelMatrices& matrices, const WearCycle& cycle,
                                        const Eigen::ArrayXd& room, double work, double accuracy) {
  const Eigen::Index n = matrices.image.rows();
  Eigen::Index inner = 0;
  while (inner < n && cycle.path.row(inner).isZero(0)) ++inner;
  Eigen::ArrayXd all = Eigen::ArrayXd::Zero(n);
  if (inner == n) return all;
  const std::optional<Eigen::ArrayXd> worn = Jump(matrices, cycle, room, inner, accuracy).worn(work);
  if (!worn) return std::nullopt;
  all.tail(n - inner) = *worn;
  return all;
}

}  // namespace fretval::mdr
