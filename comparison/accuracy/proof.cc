#include "comparison/accuracy/proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "comparison/accuracy/error_bars.h"
#include "comparison/accuracy/refinement_plan.h"
#include "comparison/accuracy/tracks.h"
#include "comparison/support/log.h"

namespace fretval {
namespace {

constexpr int most_refinements = 6, most_refinements_of_full = 2;
constexpr double most_growth_of_full = 8;
constexpr double worthwhile_gain = 4;  // a ring that is less finer than that, the error budget asks for by itself
constexpr double worthwhile_gain_if_hopeless = 1.5;  // where it asks for more than can be planned
constexpr std::array stick_radii{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown};

bool any_failed(const Tracks& tracks, const Computations& computed) {
  const auto all = tracks.all();
  return std::any_of(all.begin(), all.end(), [&](const Resolution& r) { return computed.failed(r); });
}

bool focus_on_unresolved_edges(const PreparedCase& prepared, const Computations& computed, Tracks& tracks) {
  bool any = false;
  for (const auto quantity : stick_radii) any |= focus_on(quantity, worthwhile_gain, prepared, computed, tracks);
  return any;
}

bool focus_on_what_is_hopeless(const PreparedCase& prepared, const Computations& computed, Tracks& tracks,
                               BarShares shares) {
  const auto bars = error_bars(prepared, tracks, computed, Borders::left_out, shares);
  bool any = false;
  for (const auto quantity : stick_radii) {
    const auto bar = bars.find(quantity);
    if (bar != bars.end() && bar->second.total() > most_tolerances * tolerance_of(prepared.tolerances, quantity))
      any |= focus_on(quantity, worthwhile_gain_if_hopeless, prepared, computed, tracks);
  }
  return any;
}

/// Focuses on zones that the rings do not resolve, and computes all that error bars with these shares need. Returns
/// false if the numerics failed.
bool measure_errors(const PreparedCase& prepared, Computations& computed, Tracks& tracks, BarShares shares) {
  while (true) {
    computed.compute(tracks.all());
    if (any_failed(tracks, computed)) return false;
    if (focus_on_unresolved_edges(prepared, computed, tracks)) continue;
    computed.compute(needed_for_bars(tracks, needs_of(prepared.fem), shares));
    if (!focus_on_what_is_hopeless(prepared, computed, tracks, shares)) return true;
  }
}

/// Part of a tolerance that the errors of the reference leave for the finite elements: at least half, as a bar of
/// nothing cannot be met.
double left_by_reference(const PreparedCase& prepared, Quantity quantity, double tolerance) {
  const auto errors = prepared.reference_errors();
  const auto error = errors.find(quantity);
  return error == errors.end() ? tolerance : std::max(tolerance - error->second, tolerance / 2);
}

/// The bar of a quantity with the width that it may have; tells the log if it is wider.
BarToMeet to_meet(const PreparedCase& prepared, Quantity quantity, const ErrorBar& bar) {
  // Where nothing is confirmed, no quantity has to be known better than the case asks for.
  const bool is_confirmed = prepared.is_compared() && beyond_mdr_model(prepared.input).empty();
  const double tolerance = is_confirmed
                               ? left_by_reference(prepared, quantity, tolerance_of(prepared.tolerances, quantity))
                               : prepared.input.tolerance;
  if (bar.total() > tolerance)
    log::detail(fmt::format("{}: {}", prepared.input.name, excess_text(quantity, bar, tolerance)));
  return {bar, tolerance};
}

FixedByCase fixed_by(const PreparedCase& prepared) {
  return {prepared.input.rings_per_radius || prepared.fem.given, prepared.input.steps_per_cycle.has_value()};
}

/// The next resolution, planned by the bars; tells the log what is refined. Empty: all bars meet their tolerances, or
/// nothing can be refined that would help.
std::optional<Resolution> finer(const PreparedCase& prepared, const FeAnswer& fe, const Resolution& resolution,
                                const std::vector<BarToMeet>& bars) {
  const bool is_full = prepared.fem.kind == ContactKind::plane;
  const Effort effort{static_cast<double>(fe.body->n_dofs), static_cast<double>(fe.body->radii.size() - 1),
                      static_cast<double>(fe.n_steps), is_full ? static_cast<double>(resolution.n_angles) : 0.0};
  const double most_times = is_full ? most_growth_of_full : std::numeric_limits<double>::infinity();
  const auto planned = planned_refinement(resolution, bars, effort, fixed_by(prepared), most_times);
  if (planned) log::detail(fmt::format("{}: {}", prepared.input.name, change_text(resolution, *planned)));
  return planned;
}

/// Empty: all bars meet their tolerances, or nothing can be refined that would help.
std::optional<Tracks> finer(const PreparedCase& prepared, const Computations& computed, const Tracks& tracks,
                            BarShares shares) {
  std::map<Resolution, std::vector<BarToMeet>> bars;  // by track
  for (const auto& [quantity, bar] : error_bars(prepared, tracks, computed, Borders::left_out, shares)) {
    if (!is_refined_for(quantity, prepared.tolerances)) continue;
    bars[tracks.of(quantity)].push_back(to_meet(prepared, quantity, bar));
  }
  Tracks next = tracks;
  bool any = false;
  const auto refine = [&](Resolution& track) {
    const auto planned = finer(prepared, computed.at(track).fe, track, bars[track]);
    if (!planned) return;
    track = *planned;
    any = true;
  };
  refine(next.base);
  for (auto& [quantity, track] : next.focused) refine(track);
  return any ? std::optional(next) : std::nullopt;
}

/// Refines tracks until all bars meet their tolerances or nothing helps. Returns the number of refinements.
int refine_until_proved(const PreparedCase& prepared, Computations& computed, Tracks& tracks) {
  std::optional<Tracks> before;
  for (int n = 0;; ++n) {
    // Where the share of the rings alone makes a bar too wide, the other shares need not be known.
    const auto next_for = [&](BarShares shares) {
      const int most = prepared.fem.kind == ContactKind::plane ? most_refinements_of_full : most_refinements;
      return n < most ? finer(prepared, computed, tracks, shares) : std::nullopt;
    };
    bool holds = measure_errors(prepared, computed, tracks, BarShares::of_rings);
    auto next = holds ? next_for(BarShares::of_rings) : std::nullopt;
    if (!next) holds = holds && measure_errors(prepared, computed, tracks, BarShares::all);
    if (!holds) {
      if (!before) return n;
      for (const auto& track : tracks.all())
        if (computed.failed(track))
          log::detail(fmt::format("{}: taken back: {}", prepared.input.name, computed.at(track).failure));
      tracks = *before;
      computed.compute(needed_for_bars(tracks, needs_of(prepared.fem)));
      return n;
    }
    if (!next) next = next_for(BarShares::all);
    if (!next) return n;
    before = tracks;
    tracks = *next;
  }
}

/// The answer at the base, with the stick radii of the focused tracks.
FeAnswer merged_answer(const Tracks& tracks, const Computations& computed) {
  FeAnswer fe = computed.at(tracks.base).fe;
  for (const auto& [quantity, resolution] : tracks.focused) {
    const auto& focused = computed.at(resolution).fe;
    if (quantity == Quantity::stick_radius_first_slip) {
      fe.stick_radius_first_slip = focused.stick_radius_first_slip;
      fe.first_slip_uncertainty = focused.first_slip_uncertainty;
    } else {
      fe.stick_radius_shakedown = focused.stick_radius_shakedown;
      fe.shakedown_uncertainty = focused.shakedown_uncertainty;
    }
  }
  return fe;
}

}  // namespace

const char* name_of(Proof proof) {
  if (proof == Proof::none) return "none";
  return proof == Proof::bars ? "bars" : "tolerance";
}

ProvedAnswer prove(const PreparedCase& prepared, Proof proof, BodyStore& bodies, std::size_t n_threads,
                   const ComputationsDone& told) {
  const auto& fem = prepared.fem;
  const auto whole = [&](const Resolution& resolution) { return compute_case(fem, resolution, bodies); };
  return prove(prepared, proof, whole, n_threads, told);
}

ProvedAnswer prove(const PreparedCase& prepared, Proof proof, const Compute& compute, std::size_t n_threads,
                   const ComputationsDone& told) {
  Computations computed(prepared.fem.units, compute, n_threads, told);
  Tracks tracks{prepared.fem.resolution, {}};
  ProvedAnswer answer;
  if (proof == Proof::none) computed.compute(tracks.all());
  if (proof == Proof::bars) computed.compute(needed_for_bars(tracks, needs_of(prepared.fem)));
  if (proof == Proof::tolerance) answer.n_refinements = refine_until_proved(prepared, computed, tracks);

  answer.resolution = tracks.base;
  answer.cost = computed.cost();
  const auto& base = computed.at(tracks.base).fe;
  if (base.as<GrossSlipStart>()) {
    answer.fe = base;
    answer.seconds = base.seconds_alone();
    return answer;
  }
  for (const auto& track : tracks.all())
    if (answer.failure.empty()) answer.failure = computed.at(track).failure;
  if (!answer.failure.empty()) return answer;
  answer.fe = merged_answer(tracks, computed);
  for (const auto& track : tracks.all()) answer.seconds += computed.at(track).fe.seconds_alone();
  for (const auto& [quantity, resolution] : tracks.focused) answer.focus[quantity] = *resolution.focus;
  const auto borders = proof == Proof::bars ? Borders::carried : Borders::left_out;
  if (proof != Proof::none) answer.budget = error_bars(prepared, tracks, computed, borders);
  if (proof != Proof::none && base.as<ZoneAnswer>())
    answer.zone_bars = zone_budget(tracks.base, computed, needs_of(prepared.fem));
  return answer;
}

}  // namespace fretval
