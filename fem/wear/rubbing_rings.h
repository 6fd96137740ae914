#pragma once

#include "fem/history/friction_contact.h"
#include "fem/history/normal_contact.h"
#include "fem/wear/rubbing_contact.h"

namespace fretval::fem {

/// The ring contact while the indenter wears. Prescribed forces are balanced by the sums over the rings: a worn flank
/// touches all at once, and no reading of an edge holds on it.
class RubbingRings final : public RubbingContact {
 public:
  /// The contact at rest, before the motion has begun. The problems, which share their rings, the relaxation and the
  /// motion must outlive this.
  RubbingRings(const ContactProblem& normal, const ContactProblem& tangential, const RelaxationModel& relaxation,
               const Motion& motion, int steps_per_cycle, const WornProfile& profile, double friction_coefficient);

  [[nodiscard]] std::unique_ptr<RubbingContact> clone() const override;
  Eigen::VectorXd step(const PressureWear& wear) override;
  [[nodiscard]] Eigen::VectorXd pressure() const override { return normal_.pressure; }
  [[nodiscard]] Eigen::VectorXd traction() const override { return friction_.traction; }
  [[nodiscard]] double friction_work() const override;
  [[nodiscard]] double indentation() const override { return normal_.indentation; }
  [[nodiscard]] Eigen::Vector2d displacement() const override { return {friction_.displacement, 0}; }
  [[nodiscard]] double fraction() const override { return friction_.fraction(); }
  [[nodiscard]] long n_steps() const override { return normal_.n_steps; }
  [[nodiscard]] Eigen::VectorXd worn() const override { return normal_.profile - unworn_; }
  void take_worn(const Eigen::VectorXd& worn) override { normal_.profile = unworn_ + worn; }
  void save(cereal::BinaryOutputArchive& archive) const override;
  void load(cereal::BinaryInputArchive& archive) override;

 private:
  NormalContact normal_;
  FrictionContact friction_;
  Eigen::VectorXd unworn_, slip_, traction_before_;  // of the last step
};

}  // namespace fretval::fem
