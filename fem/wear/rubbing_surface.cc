#include "fem/wear/rubbing_surface.h"

#include <cereal/archives/binary.hpp>

#include "fem/full_contact/fields.h"
#include "fem/support/eigen_archive.h"

namespace fretval::fem {

using Eigen::VectorXd;

RubbingSurface::RubbingSurface(const CoupledOperators& operators, const RelaxationModel& relaxation,
                               const Motion& motion, const IndenterMotion& of_indenter, int steps_per_cycle,
                               const WornProfile& profile, double friction_coefficient)
    : RubbingContact(motion, steps_per_cycle, operators.normal.radii(),
                     operators.normal.areas().replicate(operators.normal.grid().n_kept(), 1)),
      contact_(operators, relaxation, friction_coefficient,
               as_field(profile.unworn + profile.worn, operators.normal.n_rings()), of_indenter,
               StepTimes(motion, steps_per_cycle)),
      unworn_(profile.unworn) {}

std::unique_ptr<RubbingContact> RubbingSurface::clone() const {
  return std::make_unique<RubbingSurface>(*this);
}

VectorXd RubbingSurface::step(const PressureWear& wear) {
  const VectorXd slip_before = as_vector(lengths(contact_.friction.slip)), pressure_before = pressure();
  contact_.step(wear);
  const VectorXd pressure_after = pressure();  // which outlives the expressions of it
  const auto leaves = pressure_before.array() > 0 && pressure_after.array() == 0;
  rubs_ = (leaves && slip_before.array() == 0).select(0, VectorXd::Ones(slip_before.size()));
  return rubs_.cwiseProduct(as_vector(lengths(contact_.friction.slip)));
}

double RubbingSurface::friction_work() const {
  return rubs_.dot(as_vector(contact_.friction.friction_work_of_points()));
}

VectorXd RubbingSurface::pressure() const {
  return as_vector(contact_.pressure);
}

VectorXd RubbingSurface::traction() const {
  return as_vector(contact_.friction.traction.leftCols(contact_.pressure.cols()));
}

VectorXd RubbingSurface::worn() const {
  return as_vector(contact_.profile) - unworn_;
}

void RubbingSurface::take_worn(const VectorXd& worn) {
  contact_.profile = as_field(unworn_ + worn, contact_.profile.rows());
}

void RubbingSurface::save(cereal::BinaryOutputArchive& archive) const {
  archive(contact_);
}

void RubbingSurface::load(cereal::BinaryInputArchive& archive) {
  archive(contact_);
}

}  // namespace fretval::fem
