#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/data/motion_kind.h"
#include "comparison/scene/from_mdr.h"
#include "comparison/simulation/fem_case/body_description.h"
#include "comparison/simulation/fem_case/given_rings.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/simulation/fem_case/units.h"
#include "comparison/simulation/fem_case/worn_before.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "mdr/motion/harmonic_motion.h"

namespace fretval {

/// Where a worn profile departs from the unworn one, over the unit of length: the stick radius (0: nothing sticks) and
/// a_inf.
struct WornEdge {
  double inner, outer;
};

/// A body of finite thickness, over the unit of length.
struct Solid {
  double thickness;
  std::optional<double> radius;  ///< empty: a layer that goes on outwards
  bool slides_on_base;
};

/// What kind of contact a case has, decided once (fem_case): what is read of it, what its errors depend on, and what is
/// written of it follow from that.
enum class ContactKind {
  discs,   ///< rings touch and stick from the axis outwards: zones are discs
  worn,    ///< of a limiting profile, whose zones end at its edge: evidence of no wear
  annuli,  ///< MDR does not hold for the profile: rings touch in any order, forces are sums over them, zones annuli
  plane    ///< on rings and angles: zones are regions
};

/// The contact on rings and angles.
struct FullContact {
  bool coupled = false;           ///< pressure and friction act on each other
  bool second_algorithm = false;  ///< each step is solved once more
};

/// A case in the terms of the finite elements: dimensionless in `units`.
struct FemCase {
  Units units;
  BodyDescription body;
  fem::RelaxationModel relaxation;
  fem::Motion motion;
  double friction_coefficient;
  std::function<double(double)> profile;  ///< f(r)
  Resolution resolution;
  ContactKind kind = ContactKind::discs;
  std::optional<WornEdge> worn_edge = {};      ///< rings are graded to it: a worn profile, or one that is to wear
  std::optional<WornBefore> worn_before = {};  ///< what the indenter has lost as wear begins
  bool keeps_body = false;                     ///< an answer at this resolution goes with the whole body, for fields
  /// What is prescribed, if its frequencies have no common period, or a long one: finite elements take a near cycle
  /// then, see comparison/simulation/fem_case/near_cycle.h, with these errors of the depth that an element asks for to
  /// stick, dimensionless.
  std::optional<mdr::HarmonicMotion> without_short_cycle = {};
  /// Whether a near cycle may have other tangential frequencies, with displacements scaled to the same forces: not of a
  /// prescribed force, and not where the indenter wears, by the displacements themselves.
  bool scales_tangential = true;
  /// Radius that carries prescribed forces alone in the limiting state, of which no larger contact asks for more depth.
  double carrying_radius = 1;
  double error_of_demand = 0, error_of_normal = 0;
  double first_row = 0;  ///< s, of a path: when it begins
  MotionKind motion_kind = MotionKind::cycles;
  std::optional<Solid> solid = {};      ///< empty: a half-space
  std::optional<GivenBody> given = {};  ///< its mesh; empty: generated
  FullContact full = {};                ///< of the kind `plane`

  /// Not under an unlocked phase or of frequencies without a common period, whatever cycle is stepped in their place.
  [[nodiscard]] bool has_period() const { return motion.locked && !without_short_cycle; }
  /// Whether zones are read from points alone: no ring contact knows their edges better.
  [[nodiscard]] bool has_zones_of_points() const {
    return kind == ContactKind::plane && (full.coupled || motion.moves_across());
  }
  /// The resolution's steps belong to the fastest oscillation, or to the whole of a path, which has more if it has many
  /// rows (fem::steps_along).
  [[nodiscard]] int steps_per_cycle() const {
    return motion.path ? fem::steps_along(*motion.path, resolution.steps_per_cycle)
                       : resolution.steps_per_cycle * motion.highest_order();
  }
};

/// Tangential displacement of the indenter that uses up the friction of a unit of depth: mu times the ratio of the two
/// moduli of contact, `mu (2 - nu)/(2 (1 - nu))`, which is a local matter at the edge of a stick zone.
double tangential_per_depth(const FemCase& fem);

/// At the resolution that the tolerance of the case asks for. Of MDR it takes a guess at how deep prescribed forces go,
/// and the limiting profile where that is the indenter; all else is of the case itself. Throws InputError for what its
/// mesh has no room for.
FemCase fem_case(const Case& input, const ExpectedContact& expected, const std::optional<LimitingIndenter>& limiting);

/// Whether its body is a generated layer that goes on outwards, without friction on its base.
bool is_sliding_layer(const FemCase& fem);

/// A case at another resolution than it has.
FemCase at_resolution(FemCase fem, const Resolution& resolution);

/// What the model of a case does without because the case does not need it, in words for the log.
std::vector<std::string> left_out(const FemCase& fem);

}  // namespace fretval
