#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "comparison/quantities/reading.h"
#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/fem_case/fem_case.h"
#include "comparison/simulation/surface_answer.h"
#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/ring_contact/stick_zone/annuli.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"
#include "fem/ring_contact/stick_zone/slip_decay.h"
#include "fem/ring_contact/stick_zone/stick_depths.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"

namespace fretval {

/// Depths of the rings in the stick zones of first slip and of shakedown, where zones are discs.
struct DiscAnswer {
  fem::StickDepths first_slip_depths, shakedown_depths;
};

/// Evidence by finite elements that nothing wears any more. Dimensionless ratios.
struct NoWearEvidence {
  double slip_inside;        ///< longest slip of a ring inside c in a period over the tangential amplitude
  double force_outside;      ///< largest share of the normal force carried beyond c at any instant of the last cycle
  double touch_indentation;  ///< indentation at which the worn flank comes into contact, over the largest one
  /// Largest tangential amplitude under which nothing slips inside c, over that of the case (fem::limiting_amplitude).
  /// Empty: the indenter does not move tangentially.
  std::optional<double> limiting_amplitude;
};

/// When the whole contact begins to slide under a prescribed tangential force, while the amplitudes rise or after. An
/// answer with it has only the body and the cost beside.
struct GrossSlipStart {
  double time;       ///< s, from the start of the history, or on the time axis of a path
  double amplitude;  ///< amplitudes of all oscillations at that time, over those of the case
};

/// Number of rings that resolve the zones: in the largest contact, and inside the stick radii.
struct ZoneRings {
  Eigen::Index contact = 0;
  fem::StuckRings stuck = {};
};

/// Seconds of the histories of a case, each until it repeats; the normal one counts also where cases share it.
struct HistoryCost {
  double normal = 0, friction = 0;
};

/// The zones of a contact whose rings touch in any order; SI units.
struct ZoneAnswer {
  /// The largest contact of the cycle; rings that have never slipped; rings that do not slip any more.
  std::vector<fem::Annulus> contact, first_slip, shakedown;
  double contact_uncertainty = 0;  ///< of each end of the contact; 0: it is that of the body at rest, see read_zones
  double pressure_max = 0;         ///< Pa, mean over a ring
  double force_at_rest = 0;        ///< N, of the relaxed body at the largest indentation
  double radius_at_rest = 0;       ///< m, outermost radius of that contact
};

/// The answer of finite elements to a case; SI units. Empty stick radii: nothing sticks.
struct FeAnswer {
  std::optional<double> contact_radius_max;  ///< empty for a worn profile, whose flank touches without pressure
  std::optional<double> stick_radius_first_slip;
  std::optional<double> stick_radius_shakedown;
  double normal_force_max = 0;
  std::optional<double> indentation_max;  ///< empty: prescribed
  /// Half of the range of u_x; empty: prescribed, or a motion without period.
  std::optional<double> tangential_amplitude;
  std::optional<double> axis_pressure_max;  ///< Pa; empty: infinite
  /// Forces and works of a cycle, SI units. Empty: the indenter is worn or at rest tangentially, the phase is unlocked,
  /// or the cycle only stands for a motion without one.
  std::optional<CycleReadings> cycle;
  /// Number of cycles from rest after which nothing slips inside the shakedown radius (see cycles_until), for a locked
  /// motion. Empty: slip ends at once, or the cycles that were computed do not tell.
  std::optional<double> cycles_to_shakedown;
  double cycles_to_shakedown_uncertainty = 0;  ///< from the part of a ring inside c, see fem::SlipBeyond
  std::optional<fem::DecayFactor> slip_decay;  ///< per cycle, of a locked motion; empty: see fem::decay_factor
  MotionKind motion_kind = MotionKind::cycles;
  double contact_radius_uncertainty = 0;  ///< of the time steps, see read_contact_radius
  double contact_radius_calibration = 0;  ///< of where edges lie in their rings, see fem::ContactEvents
  /// Of the pressure on the axis, Pa: by what the exponent of the tip is at the rings that it is continued from.
  /// Infinite under a flat face that ends among these.
  double axis_pressure_uncertainty = 0;
  double normal_force_uncertainty = 0;  ///< of reading the edge, see fem::ContactForce
  double indentation_uncertainty = 0;   ///< see fem::LargestIndentation
  double first_slip_uncertainty = 0;    ///< of reading the edge, see fem::EdgeRadius
  double shakedown_uncertainty = 0;
  /// The part of the answer that depends on the kind of the contact (ContactKind), or gross slip.
  std::variant<DiscAnswer, NoWearEvidence, ZoneAnswer, SurfaceAnswer, GrossSlipStart> of_kind;

  ZoneRings rings;
  int n_cycles = 0;
  long n_steps = 0;
  fem::NormalHistory normal;      ///< dimensionless
  fem::FrictionHistory friction;  ///< dimensionless
  std::shared_ptr<const BodySummary> body;
  std::shared_ptr<const Body> whole_body;  ///< see FemCase::keeps_body; null: not asked for, or made by another case
  HistoryCost seconds;

  /// The part of a kind; null: the answer is of another kind.
  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&of_kind);
  }
  /// Seconds of the answer if it shared no body: mesh, assembly, factorisation, histories.
  [[nodiscard]] double seconds_alone() const { return body->cost.total() + seconds.normal + seconds.friction; }
};

/// The contact problems of one body.
struct ContactProblems {
  const fem::ContactProblem& normal;
  const fem::ContactProblem* tangential;  ///< null: the indenter does not move tangentially
};

/// The largest contact radius and its uncertainties, dimensionless.
struct ContactRadius {
  double radius = 0, uncertainty = 0, calibration = 0;
};

/// The largest contact radius is read at the ends of the steps, of which one is the deepest. Under a prescribed force,
/// whose largest contact lies between the steps, it is read at the balance times, and its uncertainty follows from that
/// of the force. Empty for a worn profile, see FeAnswer.
std::optional<ContactRadius> read_contact_radius(const fem::ContactProblem& problem, const FemCase& fem,
                                                 const Eigen::VectorXd& profile, const fem::NormalHistory& history);

/// Reads the largest force, pressure and indentation into an answer, and takes over the contact radius.
void read_normal_response(const ContactProblems& problems, const FemCase& fem,
                          const std::optional<ContactRadius>& contact_radius, const fem::NormalHistory& normal,
                          FeAnswer& answer);

/// Reads an answer from the histories, which it keeps; the contact radius is given. profile: ring means.
FeAnswer read_answer(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                     const std::optional<ContactRadius>& contact_radius, fem::NormalHistory normal,
                     fem::FrictionHistory&& friction);

}  // namespace fretval
