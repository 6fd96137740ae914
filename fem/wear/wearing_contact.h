#pragma once

#include <Eigen/Dense>
#include <memory>

#include "fem/wear/rubbing_contact.h"

namespace fretval::fem {

/// Local law of wear: the indenter loses `coefficient p^exponent |ds|` of its height under the pressure p on a length
/// ds of slip. The law of Reye, Archard and Khrushchov has the exponent 1; wear in proportion to the energy of friction
/// is the same law with coefficient/mu, as points that slip bear the traction mu p. The elastomer does not wear.
struct WearLaw {
  double coefficient;  ///< depth per pressure^exponent and length of slip, not negative
  double exponent = 1;
};

/// A contact whose indenter loses its shape, with the record of the last period of the motion. It is stepped without
/// wear (settle) until the slip repeats, or with wear (wear_off) for many cycles at once.
class WearingContact {
 public:
  /// contact: one at rest, before the motion has begun.
  WearingContact(std::unique_ptr<RubbingContact> contact, const WearLaw& law);
  WearingContact(const WearingContact& other);
  WearingContact(WearingContact&& other) = default;
  WearingContact& operator=(WearingContact other);
  ~WearingContact() = default;

  /// Steps through the ramp of the motion, without wear.
  void start();

  /// Steps periods without wear until the slip of each point repeats, see slip_repeats, so that the slip of settling is
  /// not taken for wear of every cycle. Throws SolverError when it does not repeat.
  void settle();

  /// Steps a period that stands for the wear of n cycles, each with the slip of the last period before: in each step a
  /// point loses the depth that n times that slip takes off under the pressure of the step, which is found together
  /// with the wear. Therefore no n, however large, wears off more than the depth at which the pressure vanishes.
  void wear_off(double n_cycles);

  /// See RubbingContact::take_worn.
  void take_worn(const Eigen::VectorXd& worn) { contact_->take_worn(worn); }

  /// Slip, pressure and wear of the points in a period.
  struct Period {
    Eigen::MatrixXd slip, pressure;  ///< points x steps; a slip of 0: the point sticks
    Eigen::MatrixXd traction;        ///< along x, points x steps
    Eigen::VectorXd path;            ///< length of slip of each point
    Eigen::VectorXd rate;            ///< wear per cycle of each point at that slip and pressure
    Eigen::VectorXd largest_pressure;
    double friction_work = 0;         ///< per cycle
    double largest_indentation = 0;   ///< of the indenter
    double tangential_amplitude = 0;  ///< of the indenter: half of the range of its displacement, along x or across

    /// What a point does in a step: o open, s sticks, f slips forward, b backward.
    [[nodiscard]] char zone(Eigen::Index point, Eigen::Index step) const;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(slip, pressure, traction, path, rate, largest_pressure, friction_work, largest_indentation,
              tangential_amplitude);
    }
  };
  [[nodiscard]] const Period& period() const { return period_; }
  [[nodiscard]] const RubbingContact& contact() const { return *contact_; }
  [[nodiscard]] Eigen::VectorXd worn() const { return contact_->worn(); }
  [[nodiscard]] int n_cycles_stepped() const {
    return static_cast<int>(contact_->n_steps() / contact_->steps_per_cycle());
  }

  template <class Archive>
  void save(Archive& archive) const {
    contact_->save(archive);
    archive(period_);
  }
  /// To be loaded into a contact that was made of the same arguments.
  template <class Archive>
  void load(Archive& archive) {
    contact_->load(archive);
    archive(period_);
  }

 private:
  [[nodiscard]] bool slip_repeats(const Eigen::VectorXd& path_before) const;
  [[nodiscard]] int period_steps() const {
    return contact_->steps_per_cycle() * contact_->motion().cycles_per_period();
  }
  void run_period(double n_cycles);
  [[nodiscard]] Eigen::MatrixXd slip_at_balances() const;
  void take_dying_slip_for_stick(const Eigen::VectorXd& path_before);

  std::unique_ptr<RubbingContact> contact_;
  WearLaw law_;
  Period period_;
};

}  // namespace fretval::fem
