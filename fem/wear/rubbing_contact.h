#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "fem/motion/motion.h"
#include "fem/ring_contact/static_contact.h"

namespace cereal {
class BinaryInputArchive;
class BinaryOutputArchive;
}  // namespace cereal

namespace fretval::fem {

/// Normal contact and friction, stepped together while the indenter wears: what WearingContact asks of a contact, be it
/// on rings (RubbingRings) or on rings and angles (RubbingSurface). Values belong to points, ray by ray and on each
/// from the centre outwards; rings are a single ray.
class RubbingContact {
 public:
  virtual ~RubbingContact() = default;
  [[nodiscard]] virtual std::unique_ptr<RubbingContact> clone() const = 0;

  /// Makes the next step, in which the indenter wears. Returns the slip of each point while it touches in the step:
  /// with its sign where slip is along x alone, otherwise its length. A point that sticks at the beginning of the step
  /// in which it leaves is taken to stick until then: of the second order of the step, as pressure and traction die out
  /// in it.
  virtual Eigen::VectorXd step(const PressureWear& wear) = 0;

  [[nodiscard]] virtual Eigen::VectorXd pressure() const = 0;  ///< at the balance time of the step
  [[nodiscard]] virtual Eigen::VectorXd traction() const = 0;  ///< along x, at the same time
  [[nodiscard]] virtual double friction_work() const = 0;      ///< of the last step, with the slip that step() returned
  [[nodiscard]] virtual double indentation() const = 0;        ///< of the indenter at the end of the step
  [[nodiscard]] virtual Eigen::Vector2d displacement() const = 0;
  [[nodiscard]] virtual double fraction() const = 0;  ///< fraction of a step at which forces balance
  [[nodiscard]] virtual long n_steps() const = 0;     ///< steps made so far
  [[nodiscard]] virtual Eigen::VectorXd worn() const = 0;
  /// Replaces the worn depth of each point; the indenter does not move thereby.
  virtual void take_worn(const Eigen::VectorXd& worn) = 0;

  /// Save and load all that the next step depends on; the contact that loads was made of the same arguments.
  virtual void save(cereal::BinaryOutputArchive& archive) const = 0;
  virtual void load(cereal::BinaryInputArchive& archive) = 0;

  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }
  /// Area that each point stands for.
  [[nodiscard]] const Eigen::VectorXd& areas() const { return areas_; }

 protected:
  /// The motion and the radii must outlive this.
  RubbingContact(const Motion& motion, int steps_per_cycle, const std::vector<double>& radii, Eigen::VectorXd areas)
      : motion_(motion), steps_per_cycle_(steps_per_cycle), radii_(radii), areas_(std::move(areas)) {}
  RubbingContact(const RubbingContact&) = default;

 private:
  const Motion& motion_;
  int steps_per_cycle_;
  const std::vector<double>& radii_;
  Eigen::VectorXd areas_;
};

/// Ring or point means: the height of an indenter before wear, and the depth that is worn off.
struct WornProfile {
  Eigen::VectorXd unworn, worn;
};

}  // namespace fretval::fem
