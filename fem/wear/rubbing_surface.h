#pragma once

#include "fem/full_contact/coupled_contact.h"
#include "fem/wear/rubbing_contact.h"

namespace fretval::fem {

/// The contact on rings and angles, coupled or not, in which the indenter may wear to a shape that is not axisymmetric.
class RubbingSurface final : public RubbingContact {
 public:
  /// The contact at rest, before the motion has begun. profile: of the points at all kept angles. of_indenter:
  /// indenter_motion() of the motion. The operators and both motions must outlive this.
  RubbingSurface(const CoupledOperators& operators, const RelaxationModel& relaxation, const Motion& motion,
                 const IndenterMotion& of_indenter, int steps_per_cycle, const WornProfile& profile,
                 double friction_coefficient);

  [[nodiscard]] std::unique_ptr<RubbingContact> clone() const override;
  Eigen::VectorXd step(const PressureWear& wear) override;
  [[nodiscard]] Eigen::VectorXd pressure() const override;
  [[nodiscard]] Eigen::VectorXd traction() const override;
  [[nodiscard]] double friction_work() const override;
  [[nodiscard]] double indentation() const override { return contact_.depth; }
  [[nodiscard]] Eigen::Vector2d displacement() const override { return contact_.friction.displacement; }
  [[nodiscard]] double fraction() const override { return contact_.friction.fraction(); }
  [[nodiscard]] long n_steps() const override { return contact_.friction.n_steps; }
  [[nodiscard]] Eigen::VectorXd worn() const override;
  void take_worn(const Eigen::VectorXd& worn) override;
  void save(cereal::BinaryOutputArchive& archive) const override;
  void load(cereal::BinaryInputArchive& archive) override;

 private:
  CoupledContact contact_;
  Eigen::VectorXd unworn_, rubs_;  // rubs_: of points, 0 where the slip of the last step does not count
};

}  // namespace fretval::fem
