#pragma once

#include <array>
#include <optional>
#include <string>

namespace fretval {

/// The quantities in which finite elements and MDR are compared. Four belong to a limiting profile: slip inside c,
/// force outside c, the indentation at which its flank touches, and the tangential amplitude at which slip begins
/// inside c. Where a normal force is prescribed the largest indentation stands for the largest force, and a tangential
/// force comes with the amplitude of the displacement. Three belong to an indenter that has worn: the volume over that
/// of the limiting profile, the outer radius of the wear, and the largest distance of the worn profile from the
/// limiting one (see distance_to_limit). The pressure on the axis, under a tip that is not sharp, has its largest value
/// in a period. Six belong to a cycle of a locked motion: the largest tangential force, its mean, which slip has locked
/// in, the energy lost to friction and, with memory, inside the body, altogether, and in the tangential loop. The decay
/// of slip is the factor per cycle by which it dies out where nothing slips in the end, and the cycles to shakedown are
/// those until it has (see cycles_until), while amplitudes rise as they do for finite elements. Where friction is a
/// vector, zones have half an extent along x and one across, beside the radius of the disc of their area, and there is
/// a largest force along y.
enum class Quantity {
  axis_pressure_max,
  bulk_work,
  contact_across,
  contact_along,
  contact_radius_max,
  cycle_work,
  cycles_to_shakedown,
  distance_to_limit,
  first_slip_across,
  first_slip_along,
  force_outside_stick_zone,
  friction_work,
  indentation_max,
  limiting_amplitude,
  maximum_indentation,
  normal_force_max,
  shakedown_across,
  shakedown_along,
  slip_decay,
  slip_inside_stick_zone,
  stick_radius_first_slip,
  stick_radius_shakedown,
  tangential_amplitude,
  tangential_force_max,
  tangential_force_mean,
  tangential_work,
  transverse_force_max,
  worn_radius,
  worn_volume
};

constexpr auto enumerated_quantities() {
  std::array<Quantity, static_cast<std::size_t>(Quantity::worn_volume) + 1> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Quantity>(i);
  return all;
}

inline constexpr auto all_quantities = enumerated_quantities();

/// All quantities, in the order in which people ask for them.
inline constexpr std::array quantities_by_interest{Quantity::stick_radius_first_slip,
                                                   Quantity::stick_radius_shakedown,
                                                   Quantity::contact_radius_max,
                                                   Quantity::first_slip_along,
                                                   Quantity::first_slip_across,
                                                   Quantity::shakedown_along,
                                                   Quantity::shakedown_across,
                                                   Quantity::contact_along,
                                                   Quantity::contact_across,
                                                   Quantity::normal_force_max,
                                                   Quantity::axis_pressure_max,
                                                   Quantity::indentation_max,
                                                   Quantity::tangential_amplitude,
                                                   Quantity::tangential_force_max,
                                                   Quantity::transverse_force_max,
                                                   Quantity::tangential_force_mean,
                                                   Quantity::tangential_work,
                                                   Quantity::friction_work,
                                                   Quantity::bulk_work,
                                                   Quantity::cycle_work,
                                                   Quantity::cycles_to_shakedown,
                                                   Quantity::slip_decay,
                                                   Quantity::distance_to_limit,
                                                   Quantity::worn_radius,
                                                   Quantity::worn_volume,
                                                   Quantity::limiting_amplitude,
                                                   Quantity::slip_inside_stick_zone,
                                                   Quantity::force_outside_stick_zone,
                                                   Quantity::maximum_indentation};

/// Order of convergence that is expected, and the highest that is credible.
struct ExpectedOrder {
  double order;
  double highest = 2 * order;
};

/// The cases in which finite elements are refined for a quantity. In other cases it is told with its bar, and compared
/// within that where it is wider than its tolerance.
enum class RefinedFor {
  any_case,
  cycles,  ///< those with a tolerance on forces and energies of a cycle
  none
};

/// What differences of a quantity are divided by; nothing: it is a ratio.
enum class Over { value, contact_radius, sliding_force, sliding_work, nothing };
struct QuantityScale {
  Over over;
  const char* words;  ///< for people
};

/// Properties of a quantity that do not depend on the case.
struct QuantityTraits {
  const char* name;   ///< in result.json
  const char* title;  ///< for people
  const char* label;  ///< title in two words, for the axis of a plot
  QuantityScale scale;
  const char* unit;   ///< of its value in SI; empty: a ratio
  double strictness;  ///< its tolerance is that of the case over this
  ExpectedOrder rings;
  RefinedFor refined_for = RefinedFor::any_case;
  bool of_friction = false;  ///< friction has a part in it: how rings are held in a step matters
  /// It tells how a motion settles, which both methods know less well than the state that it settles to.
  bool of_settling = false;
  bool of_periodic_state = false;  ///< a single pass does not have it
};
const QuantityTraits& traits_of(Quantity quantity);

/// Whether a quantity is a radius or an extent of a zone that sticks.
bool is_of_stick_zone(Quantity quantity);

/// Scales of differences and error bars, for quantities that are not compared relatively to their value.
struct Scales {
  double contact_radius;               ///< m, unworn; 0: not known, and radii are compared relatively
  double sliding_force, sliding_work;  ///< N, J; see fem::CycleResponse
};

/// Whether differences are over the value itself.
bool is_relative(Quantity quantity, const Scales& scales);

/// Scale of the differences and error bars of a quantity, in its own unit.
double scale_of(Quantity quantity, const Scales& scales, double value);

/// The value as it is shown: 0 where it is roundoff of the scale.
double without_roundoff(Quantity quantity, const Scales& scales, double value);

inline const char* name_of(Quantity quantity) {
  return traits_of(quantity).name;
}

/// Head of the column of a quantity in a CSV file, "stick radius (shakedown) [m]". who: whose value it is, " by MDR",
/// or "".
std::string column_of(Quantity quantity, const std::string& who = "");

/// The quantity of a name in result.json; empty: there is none.
std::optional<Quantity> quantity_of(const std::string& name);

}  // namespace fretval
