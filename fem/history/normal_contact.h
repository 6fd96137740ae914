#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

#include "fem/history/periodic_state.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/contact_problem.h"
#include "fem/ring_contact/ring_courses.h"
#include "fem/ring_contact/static_contact.h"

namespace fretval::fem {

/// A normal contact at the balance time of a step, as friction beside it may have to know it.
struct NormalInstant {
  const Eigen::VectorXd& touch_radii;  ///< see TouchingRings
  double radius, force;                ///< see ContactForce
  /// Of the pressure, in the PunchSeries of the tangential problem. Empty: not known, it takes a product with a
  /// triangle.
  std::optional<Eigen::Map<const Eigen::VectorXd>> pressure_depths = {};
};

/// The normal contact on its way through the motion: what it is like after the last step, and how it goes on. It begins
/// relaxed, at the mean indentation or, where a force is prescribed, under its mean: then each step finds the
/// indentation at which the force balances, by its reading. Ring pressures are unaffected by the tangential motion (nu
/// = 1/2).
class NormalContact {
 public:
  /// profile: ring means. n_inside_flank: rings inside the flank of a worn profile. The other arguments must outlive
  /// this.
  NormalContact(const ContactProblem& problem, const RelaxationModel& relaxation, Eigen::VectorXd profile,
                const Motion& motion, int steps_per_cycle, ForceReading how = ForceReading::up_to_the_edge,
                std::optional<Eigen::Index> n_inside_flank = {});

  /// Goes on by a step, in which the indenter wears. Throws SolverError when the contact reaches the last ring of the
  /// line.
  void step(const PressureWear& wear = {});

  long n_steps = 0;                ///< made
  Eigen::VectorXd profile;         ///< ring means; at the end of the step
  double time = 0;                 ///< at which forces balanced in the last step
  double indentation = 0;          ///< at the end of the step
  double balance_indentation = 0;  ///< at the balance time
  Eigen::VectorXd pressure;        ///< then
  ContactForce reading;            ///< then: force and edge of the contact
  Eigen::VectorXd gap;             ///< at the end of the step
  Eigen::VectorXd balance_gap;     ///< at the balance time
  RingState state;                 ///< at the end of the step
  Eigen::VectorXd in_contact_for;  ///< time that rings are in contact at the end of the step, over a body with memory

  [[nodiscard]] const ContactProblem& problem() const { return problem_; }
  /// That forces and edges are read from: of the problem, or under the profile (series_under) where rings touch in
  /// order.
  [[nodiscard]] const PunchSeries& series() const { return series_; }
  [[nodiscard]] const RelaxationModel& relaxation() const { return relaxation_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  /// The last step, in which rings that touch are held.
  [[nodiscard]] FrozenStep frozen() const;
  /// Where the last step lies in its piece of a path, sampled at the balance time; empty: of cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece() const;
  /// Whether rings are supposed to touch one after the other, from the centre outwards.
  [[nodiscard]] bool touches_in_order() const { return how_ == ForceReading::up_to_the_edge; }

  /// What the next step depends on; into a contact that was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_steps, profile, time, indentation, balance_indentation, pressure, reading, gap, balance_gap, state,
            in_contact_for, contact_, last_increment_);
    if (free_surface_) archive(*free_surface_, ends_of_profile_);
    if constexpr (Archive::is_loading::value) start_.rings.load = problem_.series.depths(pressure);
  }

 private:
  /// What the indenter does in a step.
  struct Move {
    IndenterMove to_balance, whole;
  };
  /// What a move of the indenter would come to.
  struct Attempt {
    std::vector<BoxState> contact;
    RingCourses courses;
    StaticContact rings;  ///< with the gaps at the end of the step
    Eigen::VectorXd balance_gap;
    Eigen::VectorXd depths, depths_of_instant, in_contact_for;  ///< at the balance time
    Opening opening;
    ContactForce reading;
    Eigen::VectorXd target;
    ContactRoom room;
  };
  /// What is there before a step goes on.
  struct Start {
    Eigen::VectorXd standing;  ///< response of rings that stay where they are
    RingsAtStart rings;        ///< with memory
  };
  void find_start();
  /// The contact of what is made: likely on entry.
  void attempt(const Move& move, const WearingSolver& solver, Attempt& made) const;
  void read(double depth, Attempt& made) const;
  [[nodiscard]] ContactForce read_elastic(const StaticContact& contact) const;
  [[nodiscard]] std::optional<ContactForce> sum(const Eigen::VectorXd& on_rings) const;
  [[nodiscard]] double start_indentation() const;
  [[nodiscard]] Move steady(double increment) const;
  [[nodiscard]] std::pair<double, Attempt> attempt_under_force(const WearingSolver& solver) const;

  const ContactProblem& problem_;
  const RelaxationModel& relaxation_;
  const Motion& motion_;
  int steps_per_cycle_;
  ForceReading how_;
  PunchSeries series_;
  std::optional<Eigen::Index> n_inside_flank_;
  StepTimes times_;
  double dt_;  // of the step that step_ is made for
  RelaxationStep step_;
  std::vector<BoxState> contact_;
  Start start_;
  Attempt made_{};                           // in the last step
  Eigen::VectorXd slip_;                     // in the same
  std::optional<FreeSurface> free_surface_;  // with memory, where rings touch in order
  Eigen::VectorXd ends_of_profile_;          // see PunchSeries::displacements
  double last_increment_ = 0;                // of the indentation
};

}  // namespace fretval::fem
