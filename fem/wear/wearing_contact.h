#pragma once

#include <Eigen/Dense>

#include "fem/history/friction_contact.h"
#include "fem/history/normal_contact.h"

namespace fretval::fem {

/// Local law of wear: the indenter loses `coefficient p^exponent |ds|` of its height under the pressure p on a length
/// ds of slip. Reye, Archard and Khrushchov have the exponent 1; the energy of friction wears as they do, with
/// coefficient/mu, as what slips bears the traction mu p. The elastomer does not wear.
struct WearLaw {
  double coefficient;  ///< depth per pressure^exponent and length of slip, not negative
  double exponent = 1;
};

/// Ring means: the height of an indenter before wear, and the depth that is worn off.
struct WornProfile {
  Eigen::VectorXd unworn, worn;
};

/// A contact that goes on and on while its indenter loses its shape: both steppers, and what the last period of the
/// motion has shown of the slip. Time goes on without wear (settle) until the slip repeats, or with it (wear_off) for
/// as many cycles at once as are asked for. Prescribed forces are balanced by the sums over the rings: a worn flank
/// touches all at once, and no reading of an edge holds on it.
class WearingContact {
 public:
  /// At rest, before the motion has begun. The problems, which share their rings, the
  /// relaxation and the motion must outlive this.
  WearingContact(const ContactProblem& normal, const ContactProblem& tangential, const RelaxationModel& relaxation,
                 const Motion& motion, int steps_per_cycle, const WornProfile& profile, double friction_coefficient,
                 const WearLaw& law);

  /// Through the ramp of the motion, without wear.
  void start();

  /// Periods without wear until the slip of each ring repeats, see slip_repeats, so that what settling takes is not
  /// taken for the wear of every cycle. Throws SolverError when it does not.
  void settle();

  /// A period that stands for the wear of n cycles, of which each slips as in the last period before: of a ring as much
  /// wears off in each step as n times that slip takes under the pressure of the step itself, found with the wear. So
  /// no n, however large, wears off more than what bears a pressure.
  void wear_off(double n_cycles);

  /// Gives the indenter another worn depth of each ring; it does not move for that.
  void take_worn(const Eigen::VectorXd& worn) { normal_.profile = unworn_ + worn; }

  /// Of the last period.
  struct Period {
    Eigen::MatrixXd slip, pressure;  ///< a column a step; a slip of 0: the ring sticks
    Eigen::VectorXd path;            ///< length of slip of each ring
    Eigen::VectorXd rate;            ///< wear per cycle of each ring at that slip and pressure
    Eigen::VectorXd largest_pressure;
    double friction_work = 0;         ///< per cycle
    double largest_indentation = 0;   ///< of the indenter
    double tangential_amplitude = 0;  ///< of the indenter: half of what it moves

    /// What a ring does in a step: o open, s sticks, f slips forward, b backward.
    [[nodiscard]] char zone(Eigen::Index ring, Eigen::Index step) const;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(slip, pressure, path, rate, largest_pressure, friction_work, largest_indentation, tangential_amplitude);
    }
  };
  [[nodiscard]] const Period& period() const { return period_; }
  [[nodiscard]] const NormalContact& normal() const { return normal_; }
  [[nodiscard]] const FrictionContact& friction() const { return friction_; }
  [[nodiscard]] Eigen::VectorXd worn() const { return normal_.profile - unworn_; }
  [[nodiscard]] int n_cycles_stepped() const { return static_cast<int>(normal_.n_steps / normal_.steps_per_cycle()); }

  /// Into a contact that was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(normal_, friction_, period_);
  }

 private:
  [[nodiscard]] bool slip_repeats(const Eigen::VectorXd& path_before) const;
  [[nodiscard]] int period_steps() const { return normal_.steps_per_cycle() * normal_.motion().cycles_per_period(); }
  void run_period(double n_cycles);
  Eigen::VectorXd step(const PressureWear& wear);
  [[nodiscard]] Eigen::MatrixXd slip_at_balances() const;
  void take_dying_slip_for_stick(const Eigen::VectorXd& path_before);

  NormalContact normal_;
  FrictionContact friction_;
  WearLaw law_;
  Eigen::VectorXd unworn_;
  Period period_;
};

}  // namespace fretval::fem
