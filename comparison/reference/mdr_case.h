#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/data/motion_kind.h"
#include "comparison/scene/scene.h"
#include "mdr/layer/layer.h"
#include "mdr/motion/harmonic_motion.h"
#include "mdr/motion/motion.h"
#include "mdr/motion/sampled_path.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"
#include "mdr/springs/forced_response.h"
#include "mdr/stick/limiting_motion.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval {

/// A case in the terms of the analytic reference, as far as finite elements can be compared with it: what is prescribed
/// repeats. SI units, angles in radians. The body is an incompressible half-space: of another Poisson's ratio the one
/// of incompressible_case, whose tangential displacements are larger.
struct MdrCase {
  mdr::Profile profile;
  mdr::PronyBody body;
  double friction_coefficient;
  mdr::HarmonicMotion motion;                           ///< see motion_of_case
  std::optional<mdr::LimitingProfile> limiting;         ///< Wear / State = limiting: the indenter itself
  bool normal_force = false, tangential_force = false;  ///< what is prescribed; false: displacements
  /// What forces lead to; empty: no forces, a path, a motion in two directions, or no limiting state. A limiting
  /// profile under forces is its.
  std::optional<mdr::LimitingMotion> limiting_state = {};

  /// Instead of the motion, which tells then how large the path is (see Case::Motion).
  std::optional<mdr::SampledPath> path = {};
  MotionKind motion_kind = MotionKind::cycles;

  /// MDR's own layer instead of the half-space; then the body is that of the case.
  std::optional<mdr::Layer> layer = {};

  double displacement = 1;  ///< tangential displacements here over those of the case, see incompressible_case

  /// Of the case, on stick radii over the contact radius (0: none), and on forces and energies of a cycle. Springs are
  /// refined to a quarter of them (excess_of).
  double tolerance = 0;
  std::optional<double> cycle_tolerance = {};
  /// Springs, and steps of an oscillation, are so many times fewer than usual, for the line of a plot: what they err by
  /// goes with the square of it.
  int coarser_springs = 1;

  [[nodiscard]] bool is_single_pass() const { return is_pass(motion_kind); }
  /// Not under an unlocked phase or of frequencies without a common period.
  [[nodiscard]] bool has_period() const { return path || (motion.phase_locked && mdr::common_cycle(motion)); }
  /// Where the image of the profile falls (mdr::falls_of_image); not empty: MDR does not hold, and is not asked.
  [[nodiscard]] std::vector<mdr::FallOfImage> falls() const { return mdr::falls_of_image(profile); }
  [[nodiscard]] bool has_forces() const { return normal_force || tangential_force; }
  [[nodiscard]] mdr::Prescribed prescribed() const { return {motion, normal_force, tangential_force}; }
  /// The part of what is prescribed that the normal response depends on.
  [[nodiscard]] mdr::Prescribed prescribed_normally() const;
};

/// Contact radius of the unworn indenter at an indentation, both in m.
double unworn_radius_at(const MdrCase& mdr, double indentation);

/// Largest indentation that is reached or, under a normal force, an upper bound of it (mdr::deepest_indentation). In a
/// limiting state that forces lead to, that of the state.
double deepest_indentation(const MdrCase& mdr);

/// All that finite elements are given of a case by MDR.
ExpectedContact expected_contact(const MdrCase& mdr);
/// Empty: the case asks for no limiting profile.
std::optional<LimitingIndenter> limiting_indenter(const MdrCase& mdr);

/// Throws InputError for a case that is not comparable (see is_comparable), for what has no meaning where MDR does
/// not hold for the profile (prescribed forces, limiting profiles, wear), or for a limiting state that no tangential
/// amplitude leads to, std::invalid_argument for values that the reference refuses.
MdrCase mdr_case(const Case& input);

/// Whether finite elements compute the case, too. Only the reference covers three frequencies or more of which no two
/// have a common period, frequencies more than a factor of 1000 apart, and a prescribed normal force that is not always
/// positive.
bool is_comparable(const Case& input);

/// What of a case MDR does not compute, for people: "the body is a cylinder", "friction is a vector", "pressure and
/// friction are coupled". Then its answer is one to another model.
std::vector<std::string> beyond_mdr_model(const Case& input);

/// What a test rig prescribes, of the first harmonic of each direction.
mdr::FrettingControl control_of(const mdr::Prescribed& prescribed);

/// The motion of a case that has one harmonic in each direction. Throws InputError, naming what needs it, for others.
mdr::Motion one_harmonic_each_of(const Case& input, const MdrCase& mdr, const std::string& what);

/// The share of all amplitudes at which the steady motion begins to slide as a whole, where that is algebra: one
/// frequency, both forces prescribed, F_0 + dF cos(wt) and F_x cos(wt + phi). Friction carries no more where
///   lambda |F_x e^{i phi} ± mu dF| = mu F_0,
/// or, with an unlocked phase, of which the worst value comes, where lambda (F_x + mu dF) = mu F_0. This is the balance
/// of forces, and holds for any indenter and body. Below 1 the case slides. Empty: no such case, or nothing moves.
std::optional<double> steady_sliding_share(const MdrCase& mdr);

}  // namespace fretval
