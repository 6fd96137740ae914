#include "fem/wear/rubbing_rings.h"

#include <cereal/archives/binary.hpp>
#include <cereal/types/vector.hpp>

#include "fem/support/eigen_archive.h"

namespace fretval::fem {

RubbingRings::RubbingRings(const ContactProblem& normal, const ContactProblem& tangential,
                           const RelaxationModel& relaxation, const Motion& motion, int steps_per_cycle,
                           const WornProfile& profile, double friction_coefficient)
    : RubbingContact(motion, steps_per_cycle, normal.compliance.radii, normal.compliance.areas),
      normal_(normal, relaxation, profile.unworn + profile.worn, motion, steps_per_cycle, ForceReading::sum_of_rings),
      friction_(tangential, relaxation, friction_coefficient, motion, steps_per_cycle),
      unworn_(profile.unworn) {}

std::unique_ptr<RubbingContact> RubbingRings::clone() const {
  return std::make_unique<RubbingRings>(*this);
}

Eigen::VectorXd RubbingRings::step(const PressureWear& wear) {
  const Eigen::VectorXd slip_before = friction_.slip, pressure_before = normal_.pressure;
  traction_before_ = friction_.traction;
  normal_.step(wear);
  friction_.step(normal_.pressure);
  const auto leaves = pressure_before.array() > 0 && normal_.pressure.array() == 0;
  slip_ = (leaves && slip_before.array() == 0).select(0, friction_.slip);
  return slip_;
}

double RubbingRings::friction_work() const {
  const double later = fraction() - 0.5;
  return ((1 - later) * friction_.traction + later * traction_before_).cwiseProduct(slip_).dot(areas());
}

void RubbingRings::save(cereal::BinaryOutputArchive& archive) const {
  archive(normal_, friction_);
}

void RubbingRings::load(cereal::BinaryInputArchive& archive) {
  archive(normal_, friction_);
}

}  // namespace fretval::fem
