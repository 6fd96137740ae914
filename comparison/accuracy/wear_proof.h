#pragma once

#include <optional>

#include "comparison/accuracy/proof.h"
#include "comparison/accuracy/wear_computations.h"

namespace fretval {

/// The wear of a case by finite elements, compared with MDR.
struct ProvedWear {
  WearSimulation fe;  ///< at the chosen resolution
  std::string failure = {};
  Resolution resolution;
  WearLimits limits;
  std::optional<mdr::WearKinetics> kinetics = {};  ///< to the last cycle of the finite elements; see wear_kinetics_of
  /// Distances of the profile from the limits of shakedown and of first slip at each point of the course, see
  /// distances_of.
  std::vector<double> distance_shakedown = {}, distance_first_slip = {};
  /// slip_is_proved: whether the energy that friction takes in a cycle of the unworn contact exceeds its error bar. If
  /// not, the wear may be that of the error of the slip in many cycles, and nothing is compared, unless the springs do
  /// not slip at all either (sticks_throughout).
  bool slip_is_proved = true, sticks_throughout = false;
  /// Largest difference from the volume of the springs along the course, over that of the limit.
  std::optional<double> largest_springs_difference = {};
  /// Error of the volume by springs, over that of the limit. Set where this volume is compared: while wear is on its
  /// way, or in full stick.
  std::optional<double> springs_error = {};
  /// Error bar of the last volume rate over that rate, for progressive wear.
  std::optional<double> rate_error = {};
  /// Force that the largest pressures in a cycle bear outside the stick radius (and the tolerance of the distance) at
  /// the end, over that of the whole contact at the start. Where wear has ended and this is not 0, rings that are
  /// pressed there stick.
  double pressed_outside = 0;
  Comparison comparison = {};
  ProofCost cost = {};  ///< of all computations

  /// Whether wear has ended because nothing is pressed any more where it slips.
  [[nodiscard]] bool ends_in_limit() const;
};

/// Whether the wear of a case is run: it asks for it, and the indenter moves tangentially.
bool wears(const PreparedCase& prepared);

/// Runs the wear of a case, with the rings graded around the stick radius that edge_of_wear finds, and measures its
/// errors by refinement (variants_of_wear). With Proof::tolerance the largest share is refined until all bars are
/// within the tolerance, at most twice. Progressive wear has an error bar of its rate. Where it is open whether
/// anything slips, wear is computed once, without error bars.
ProvedWear prove_wear(const PreparedCase& prepared, const MdrAnswer& mdr, const ProvedAnswer& unworn, Proof proof,
                      BodyStore& bodies, const WearOversight& oversight = {});

}  // namespace fretval
