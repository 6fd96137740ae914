#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/data/motion_kind.h"
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
  /// Without still harmonics; time 0: an instant of largest indentation or, where it is prescribed, normal force. A
  /// force stands in the place of the displacement.
  mdr::HarmonicMotion motion;
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

  /// On forces and energies of a cycle, which springs are refined to a quarter of (see mdr_answer_with_cycle).
  std::optional<double> cycle_tolerance = {};

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

/// The motion of the case itself, whatever Poisson's ratio.
mdr::HarmonicMotion motion_of_case(const MdrCase& mdr);

/// Contact radius of the unworn indenter at an indentation, both in m.
double unworn_radius_at(const MdrCase& mdr, double indentation);

/// Oscillations in the longest cycle that either method steps through as it is.
constexpr int longest_cycle = 200;

/// Largest indentation that is reached or, under a normal force, an upper bound of it (mdr::deepest_indentation), which
/// the body of the finite elements is made for. In a limiting state that forces lead to, that of the state.
double deepest_indentation(const MdrCase& mdr);

/// Throws InputError for a case that is not comparable (see require_comparable), for what has no meaning where MDR does
/// not hold for the profile (prescribed forces, limiting profiles, wear), or for a limiting state that no tangential
/// amplitude leads to, std::invalid_argument for values that the reference refuses.
MdrCase mdr_case(const Case& input);

/// Throws InputError, naming the entry, for a case that only the reference covers: three frequencies or more of which
/// no two have a common period, frequencies more than a factor of 1000 apart, a prescribed normal force that is not
/// always positive.
void require_comparable(const Case& input);

/// Whether require_comparable would not throw.
bool is_comparable(const Case& input);

/// What of a case MDR does not compute, for people: "the body is a cylinder", "friction is a vector", "pressure and
/// friction are coupled". Then its answer is one to another model.
std::vector<std::string> beyond_mdr_model(const Case& input);

/// The parts of a case, whether comparable or not. Tables are read here: InputError with file and line.
mdr::Profile profile_of(const Case::Indenter& indenter);
/// "its one-dimensional image g(x) falls for x = 1e-4 to 2e-4 m"; empty: it rises.
std::string falls_text(const mdr::Profile& profile);
/// A profile whose image may fall, as that of a table, which profile_of refuses because MDR does not hold for it.
mdr::Profile any_profile_of(const Case::Indenter& indenter);
mdr::Rheology rheology_of(const Case::Elastomer& elastomer);
/// The body in time: a fractional one is approximated from a tenth of its lowest frequency of motion to a thousand
/// times it.
mdr::PronyBody body_in_time(const Case& input);
mdr::HarmonicMotion harmonic_motion_of(const Case::Motion& motion);
/// What a test rig prescribes, of the first harmonic of each direction.
mdr::FrettingControl control_of(const mdr::Prescribed& prescribed);

/// The motion of a case that has one harmonic in each direction. Throws InputError, naming what needs it, for others.
mdr::Motion one_harmonic_each_of(const Case& input, const MdrCase& mdr, const std::string& what);

}  // namespace fretval
