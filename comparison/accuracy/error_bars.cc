#include "comparison/accuracy/error_bars.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/accuracy/fe_readings.h"
#include "fem/motion/stepped_stiffening.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

/// Uncertainties of reading the edges, in the units of the comparison.
Quantities uncertainties_of_edges(const Computation& computation, const FemCase& fem) {
  if (!computation.failure.empty()) return {};
  return uncertainties_of(readings_of(computation.fe, fem.units), scales_of(computation.fe, fem.units));
}

std::vector<Variant> variants_of(const Resolution& resolution, const CaseNeeds& needs, BarShares shares) {
  auto variants = variants_of(resolution, needs);
  const auto is_left_out = [shares](const Variant& variant) {
    return shares == BarShares::of_rings && variant.source != ErrorSource::rings;
  };
  variants.erase(std::remove_if(variants.begin(), variants.end(), is_left_out), variants.end());
  return variants;
}

/// Uncertainties of reading the edges on the coarser rings of a budget, which may show hardly more of a zone than that
/// it exists.
std::map<Resolution, Quantities> readings_of_rings(const Resolution& resolution, const CaseNeeds& needs,
                                                   const Computations& computed, const FemCase& fem) {
  std::map<Resolution, Quantities> readings;
  for (const auto& variant : variants_of(resolution, needs))
    if (variant.source == ErrorSource::rings)
      readings[variant.resolution] = uncertainties_of_edges(computed.at(variant.resolution), fem);
  return readings;
}

double share_of(const ErrorBar& bar, ErrorSource source) {
  const auto found = std::find_if(bar.shares.begin(), bar.shares.end(),
                                  [source](const ErrorShare& share) { return share.source == source; });
  return found == bar.shares.end() ? 0 : found->estimate;
}

/// Widens the share of a source. A difference of two infinite shares would be no number.
void widen_share(ErrorBar& bar, ErrorSource source, double width) {
  if (const double own = share_of(bar, source); width > own) bar.add(source, width - own);
}

/// Widens a bar to a width, by a share of the edge.
void widen(ErrorBar& bar, double width) {
  const double missing = width - bar.total();
  if (missing > 0) bar.add(ErrorSource::edge, missing);
}

/// The depth of a stick zone goes at least with the square of its radius: a bar of more than half of the radius leaves
/// open whether anything sticks at all.
void widen_to_none(double c, ErrorBar& bar) {
  constexpr double all_of_it = 1.01;
  if (bar.total() > c / 2) widen(bar, all_of_it * c);
}

/// A track of a proof, with the computations at its resolution.
struct Track {
  const PreparedCase& prepared;
  const Computations& computed;
  const Resolution& resolution;

  [[nodiscard]] double value(Quantity quantity) const { return computed.quantities().at(resolution).at(quantity); }
};

/// Whether the rings that stick around the centre end with the smallest contact of a cycle, or hardly inside it.
bool ends_with_contact(const Eigen::VectorXd& smallest_pressure, Eigen::Index n_stuck) {
  constexpr Eigen::Index hardly = 2;
  const Eigen::Index n_next = std::min(hardly, smallest_pressure.size() - n_stuck);
  return n_stuck > 0 && n_next > 0 && smallest_pressure.segment(n_stuck, n_next).minCoeff() <= 0;
}

/// What the errors of a case depend on, with what its answer shows: whether stick zones end with the smallest contact.
CaseNeeds needs_of(const FemCase& fem, const Computation& computation) {
  auto needs = needs_of(fem);
  if (!computation.failure.empty() || fem.kind != ContactKind::discs) return needs;
  const auto& fe = computation.fe;
  const Eigen::VectorXd smallest = fe.normal.pressure.rowwise().minCoeff();
  needs.first_slip_ends_with_contact = ends_with_contact(smallest, fe.rings.stuck.first_slip);
  needs.shakedown_ends_with_contact = ends_with_contact(smallest, fe.rings.stuck.shakedown);
  return needs;
}

/// Depths of the innermost ring in the two stick zones.
Quantities centre_depths(const FeAnswer& fe) {
  const auto& [first_slip, shakedown] = *fe.as<DiscAnswer>();
  return {{Quantity::stick_radius_first_slip, first_slip.depth[0]},
          {Quantity::stick_radius_shakedown, shakedown.depth[0]}};
}

/// Where the error of the depth at the centre leaves open whether anything sticks, adds to the bar what that means for
/// the stick radius: under a flat face, all of the face or nothing, also where rings inside it seem to stick.
void carry_depths(const Track& track, ErrorBudget& budget) {
  const auto& [prepared, computed, resolution] = track;
  if (prepared.fem.kind == ContactKind::worn || computed.failed(resolution)) return;
  std::map<Resolution, Quantities> centre;
  for (const auto& [other, unused] : computed.quantities())
    centre[other] = computed.failed(other) ? Quantities{} : centre_depths(computed.at(other).fe);
  // At the border between some stick and none the bar of a depth is hardly larger than its error. Where nothing sticks,
  // slips stand for depths, and next to the edge of a flat face they do not do so.
  constexpr double safety = 2, rings_next_to_face = 8;
  const double face = prepared.input.indenter.flat_radius / prepared.fem.units.length,
               around_face = face > 0 ? face + rings_next_to_face / resolution.elements_per_radius : 0;
  const auto& [first_slip, shakedown] = *computed.at(resolution).fe.as<DiscAnswer>();
  for (const auto& [quantity, bar] : error_budget(resolution, centre, {}, needs_of(prepared.fem))) {
    if (budget.count(quantity) == 0) continue;  // a pass may not have both stick radii
    const double c = track.value(quantity), uncertainty = safety * bar.total();
    if (std::abs(centre.at(resolution).at(quantity)) > uncertainty) continue;
    const auto& depths = quantity == Quantity::stick_radius_first_slip ? first_slip : shakedown;
    const double reach = fem::reach_of_edge(depths, c, uncertainty);
    widen(budget.at(quantity), std::max(reach, around_face - c));
  }
}

/// While an unlocked phase drifts too fast for the body, rings slip on the way that would not: where the first-slip
/// zone is none, it may be all that sticks in the end.
void carry_drift(const Track& track, ErrorBudget& budget) {
  constexpr auto first_slip = Quantity::stick_radius_first_slip, shakedown = Quantity::stick_radius_shakedown;
  if (!needs_of(track.prepared.fem).creep || track.computed.failed(track.resolution) || track.value(first_slip) > 0)
    return;
  widen(budget.at(first_slip), track.value(shakedown) + budget.at(shakedown).total());
}

/// How far the two stick radii are apart that are equal under an unlocked phase, as every harmonic moves as far forward
/// as backward: one of them is off by half of that at least. 0 where several harmonics need not do so, or nothing
/// sticks in the end or on the way (carry_drift).
double apart(const Track& track) {
  const double first_slip = track.value(Quantity::stick_radius_first_slip),
               shakedown = track.value(Quantity::stick_radius_shakedown);
  const bool are_equal = track.prepared.fem.motion.tangential.size() == 1 && first_slip > 0 && shakedown > 0;
  return are_equal ? std::abs(first_slip - shakedown) : 0;
}

/// Under an unlocked phase the larger of the shares of creep of the two stick radii is a share of both, and so is how
/// far they are apart.
void carry_creep(const Track& track, ErrorBudget& budget) {
  if (!needs_of(track.prepared.fem).creep) return;
  const auto creep_of = [&](Quantity quantity) { return share_of(budget.at(quantity), ErrorSource::creep); };
  const double share =
      std::max({creep_of(Quantity::stick_radius_first_slip), creep_of(Quantity::stick_radius_shakedown), apart(track)});
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
    widen_share(budget.at(quantity), ErrorSource::creep, share);
}

/// A cycle that stands for a motion without a common period demands a little less or more depth of an element that
/// sticks than the motion does.
void carry_near_cycle(const Track& track, ErrorBudget& budget) {
  const auto& [prepared, computed, resolution] = track;
  const auto fem = at_resolution(prepared.fem, resolution);
  if (fem.error_of_demand == 0 || computed.failed(resolution)) return;
  const auto add = [&budget](Quantity quantity, double error) {
    const auto found = budget.find(quantity);
    if (found != budget.end()) found->second.add(ErrorSource::creep, error);
  };
  // A force of a contact of f ~ r^n, n at least 1, is n/(n + 1) of that of a flat punch of the same depth.
  const double relative = 2 * fem.error_of_normal;
  add(Quantity::axis_pressure_max, relative);
  if (fem.motion.normal_force) {
    add(Quantity::indentation_max, relative);
    add(Quantity::contact_radius_max, relative);
  } else {
    add(Quantity::normal_force_max, relative);
  }
  const auto* discs = computed.at(resolution).fe.as<DiscAnswer>();
  if (!discs) return;
  add(Quantity::stick_radius_first_slip, fem::width_of_edge(discs->first_slip_depths, fem.error_of_demand));
  add(Quantity::stick_radius_shakedown, fem::width_of_edge(discs->shakedown_depths, fem.error_of_demand));
}

/// By which share of their amplitude, or by which angle, steps put off what oscillating forces move the indenter by, as
/// far as the contact sticks.
double off_under_forces(const FemCase& fem, const std::vector<fem::Oscillation>& forces) {
  const double dt = 2 * fem::pi / fem.steps_per_cycle();
  double largest = 0;
  for (const auto& force : forces) {
    const auto exact = fem::stiffening_at(fem.relaxation, force.order),
               stepped = fem::stepped_stiffening_at(fem.relaxation, force.order, dt);
    largest = std::max(largest, std::abs(exact / stepped - 1.0));
  }
  return largest;
}

/// Where an indenter follows forces, the error of the steps is known in advance but for what slips. Differences between
/// numbers of steps may be small by chance where a branch is shorter than a step (stepped_stiffening_at).
void carry_steps_under_forces(const Track& track, ErrorBudget& budget) {
  const auto& [prepared, computed, resolution] = track;
  const auto fem = at_resolution(prepared.fem, resolution);
  if (fem.motion.path || computed.failed(resolution)) return;
  const auto widen_to = [&budget](Quantity quantity, double least) {
    if (const auto bar = budget.find(quantity); bar != budget.end())
      widen_share(bar->second, ErrorSource::time_step, least);
  };
  if (fem.motion.tangential_force)
    widen_to(Quantity::tangential_amplitude, off_under_forces(fem, fem.motion.tangential));
  const auto& depths = computed.at(resolution).fe.normal.indentation;
  if (fem.motion.normal_force && depths.size() > 0) {
    const double oscillates = (depths.maxCoeff() - depths.minCoeff()) / 2 / depths.maxCoeff(),
                 off = oscillates * off_under_forces(fem, fem.motion.normal);
    widen_to(Quantity::indentation_max, off);
    widen_to(Quantity::contact_radius_max, off);
  }
}

/// The rings of a worn profile that stick are counted. Where the slip inside its stick radius is no more than its own
/// bar, all rings up to there may stick.
void carry_slip_inside(const Track& track, ErrorBudget& budget) {
  const auto slip = budget.find(Quantity::slip_inside_stick_zone);
  if (slip == budget.end() || track.value(slip->first) > slip->second.total()) return;
  constexpr auto shakedown = Quantity::stick_radius_shakedown;
  const double missing = track.prepared.fem.worn_edge->inner - track.value(shakedown);
  if (missing > 0) budget.at(shakedown).add(ErrorSource::edge, missing);
}

/// On another body than a half-space the places of edges within rings are taken from a half-space, with an error that
/// is the same share of a ring on all meshes.
void carry_calibration(const FemCase& fem, const Computation& computation, ErrorBudget& budget) {
  const double calibration = computation.fe.contact_radius_calibration;
  const auto found = budget.find(Quantity::contact_radius_max);
  if (calibration > 0 && found != budget.end()) found->second.add(ErrorSource::edge, calibration / fem.units.length);
}

/// Shares of readings of the cycle, each over the scale of its quantity.
Quantities over_scales(const FemCase& fem, const Computation& computation,
                       const std::map<Quantity, double> CycleReadings::*shares) {
  Quantities all;
  if (!computation.failure.empty() || !computation.fe.cycle) return all;
  const auto readings = readings_of(computation.fe, fem.units);
  const auto scales = scales_of(computation.fe, fem.units);
  for (const auto& [quantity, share] : *computation.fe.cycle.*shares)
    if (const auto found = readings.find(quantity); found != readings.end() && share != 0)
      all[quantity] = share / scale_of(quantity, scales, found->second.value.value_or(0));
  return all;
}

/// The quantities by resolution without what steps within which sliding ends put them off by, which would hide the
/// order in which they converge. Of a body with memory it is a bound alone: what is locked in fades.
std::map<Resolution, Quantities> converging_quantities(const FemCase& fem, const Computations& computed) {
  auto all = computed.quantities();
  if (fem.relaxation.has_memory()) return all;
  for (auto& [resolution, quantities] : all)
    for (const auto& [quantity, off] : over_scales(fem, computed.at(resolution), &CycleReadings::off_by_steps))
      if (const auto found = quantities.find(quantity); found != quantities.end()) found->second -= off;
  return all;
}

/// What single steps are off by whatever is computed with other ones.
void carry_single_steps(const FemCase& fem, const Computation& computation, ErrorBudget& budget) {
  for (const auto shares : {&CycleReadings::off_by_steps, &CycleReadings::between_steps})
    for (const auto& [quantity, share] : over_scales(fem, computation, shares))
      if (const auto bar = budget.find(quantity); bar != budget.end())
        bar->second.add(ErrorSource::time_step, std::abs(share));
}

/// A relative bar of the whole value leaves open whether there is anything. In logarithms nothing is infinitely far
/// away.
void carry_unknown_sizes(const FemCase& fem, const Computation& computation, ErrorBudget& budget) {
  if (!computation.failure.empty()) return;
  const auto scales = scales_of(computation.fe, fem.units);
  for (auto& [quantity, bar] : budget)
    if (is_relative(quantity, scales) && bar.total() >= 1)
      bar.add(bar.largest()->source, std::numeric_limits<double>::infinity());
}

/// Adds the shares of stick radii that differences between resolutions do not show.
void carry_to_stick_radii(const Track& track, Borders borders, ErrorBudget& bars) {
  if (borders == Borders::carried) carry_depths(track, bars);
  if (!track.computed.failed(track.resolution)) carry_creep(track, bars);
  if (track.prepared.fem.kind == ContactKind::worn) carry_slip_inside(track, bars);
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
    if (bars.count(quantity) > 0) widen_to_none(track.value(quantity), bars.at(quantity));
  if (borders == Borders::carried) carry_drift(track, bars);
}

}  // namespace

CaseNeeds needs_of(const FemCase& fem) {
  CaseNeeds needs;
  needs.memory = fem.relaxation.has_memory();
  needs.creep = !fem.motion.locked;
  needs.without_period = needs.creep || fem.without_short_cycle;
  needs.kind = fem.kind;
  needs.motion_kind = fem.motion_kind;
  needs.held_from_start =
      fem.relaxation.viscosity > 0 || fem.motion.tangential_force || fem.kind == ContactKind::annuli;
  needs.moves_by_steps = fem.motion.tangential_force || fem.motion.path;
  needs.begins_anywhere = fem.kind == ContactKind::discs && fem.has_period() && !fem.motion.path;
  const double two_steps = 4 * fem::pi / fem.steps_per_cycle();
  const auto& times = fem.relaxation.times;
  needs.has_short_branch = std::any_of(times.begin(), times.end(), [=](double time) { return time < two_steps; });
  needs.ends = fem.solid.has_value();
  needs.stretches = is_sliding_layer(fem);
  return needs;
}

std::vector<Resolution> needed_for_bars(const Tracks& tracks, const CaseNeeds& needs, BarShares shares) {
  auto needed = tracks.all();
  for (const auto& track : tracks.all())
    for (const auto& variant : variants_of(track, needs, shares)) {
      needed.push_back(variant.resolution);
      needed.push_back(variant.reference);
    }
  return needed;
}

ErrorBudget error_bars(const PreparedCase& prepared, const Tracks& tracks, const Computations& computed,
                       Borders borders, BarShares shares) {
  ErrorBudget all;
  const auto converging = converging_quantities(prepared.fem, computed);
  for (const auto& resolution : tracks.all()) {
    const Track track{prepared, computed, resolution};
    const auto needs = needs_of(prepared.fem, computed.at(resolution));
    auto bars = error_budget(resolution, variants_of(resolution, needs, shares), converging,
                             uncertainties_of_edges(computed.at(resolution), prepared.fem), needs,
                             readings_of_rings(resolution, needs, computed, prepared.fem));
    carry_calibration(prepared.fem, computed.at(resolution), bars);
    if (shares != BarShares::of_rings) {
      carry_steps_under_forces(track, bars);
      carry_single_steps(prepared.fem, computed.at(resolution), bars);
    }
    if (prepared.fem.kind == ContactKind::discs || prepared.fem.kind == ContactKind::worn) {
      carry_near_cycle(track, bars);
      carry_to_stick_radii(track, borders, bars);
    }
    carry_unknown_sizes(prepared.fem, computed.at(resolution), bars);
    for (const auto& [quantity, bar] : bars)
      if (tracks.of(quantity) == resolution) all[quantity] = bar;
  }
  return all;
}

}  // namespace fretval
