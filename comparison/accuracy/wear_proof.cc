#include "comparison/accuracy/wear_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "comparison/simulation/wear_run.h"
#include "comparison/support/log.h"

namespace fretval {
namespace {

constexpr int most_rounds = 4;  // each mends one source of error

std::vector<Resolution> needed_for_bars(const Resolution& resolution) {
  std::vector<Resolution> needed;
  for (const auto& variant : variants_of_wear(resolution)) {
    needed.push_back(variant.reference);
    needed.push_back(variant.resolution);
  }
  return needed;
}

Quantities quantities_of(const WearSimulation& wear, const Units& units, const WearLimits& limits) {
  return {{Quantity::worn_volume, wear.end_volume * units.volume() / limits.shakedown.volume},
          {Quantity::worn_radius, wear.worn_radius}};
}

double stick_radius_of(const WearSimulation& wear) {
  return wear.end.stick.radius;
}

/// Error of the stick radius at the end of wear, 0 if nothing sticks. Under prescribed displacements over a half-space
/// it should be that of the unworn contact, and what wear has taken of that is an error, too.
double stick_radius_error(const PreparedCase& prepared, const WearSimulation& wear, double unworn_stick_radius) {
  const auto [stick_radius, uncertainty] = wear.end.stick;
  if (stick_radius == 0) return 0;
  return std::max(uncertainty, stick_radius_moves(prepared.fem) ? 0 : std::abs(unworn_stick_radius - stick_radius));
}

/// Worn volume of the limiting state for a stick radius c, up to a factor: it vanishes like (a - c)^(5/2) as c comes to
/// the contact radius a = 1, and depends less on c further inside.
double volume_beyond(double stick_radius) {
  return stick_radius < 1 ? std::pow(1 - stick_radius, 2.5) : 1;
}

/// Adds the error of ending a course before all wear is over: the wear of as many further cycles at the rate of the
/// last jump, which is an upper bound as wear dies out.
void add_stop(const ProvedWear& wear, const Units& units, ErrorBudget& budget) {
  const auto& [curve, worn] = std::tie(wear.fe.course.curve, wear.fe.course.worn);
  if (curve.size() < 2) return;
  const auto& [before, last] = std::tie(*(curve.end() - 2), curve.back());
  const auto& limit = wear.limits.shakedown;
  const double jumps = last.cycles / (last.cycles - before.cycles),
               depth = jumps * (worn.back() - *(worn.end() - 2)).maxCoeff(),
               volume = jumps * (last.volume - before.volume);
  budget[Quantity::distance_to_limit].add(ErrorSource::cycles, depth * units.depth / limit.maximum_indentation);
  budget[Quantity::worn_volume].add(ErrorSource::cycles, volume * units.volume() / limit.volume);
}

/// The course of wear has variants of its own: of all that errors depend on, only the memory of the body matters.
CaseNeeds needs_of_wear(const FemCase& fem) {
  CaseNeeds needs;
  needs.memory = fem.relaxation.has_memory();
  return needs;
}

/// The budget of wear. The error of the stick radius at the end is a share of its own. Where that is only known to
/// whole rings it jumps, and the volume with it: such refinements are compared at the stick radius of the answer.
ErrorBudget budget_of(const PreparedCase& prepared, const ProvedWear& wear, double unworn_stick_radius,
                      const WearComputations& computed) {
  const auto& units = prepared.fem.units;
  const auto& [limits, resolution] = std::tie(wear.limits, wear.resolution);
  const auto& fe = computed.all.at(resolution).fe;
  const auto variants = variants_of_wear(resolution);
  const auto needs = needs_of_wear(prepared.fem);
  std::map<Resolution, Quantities> known;
  std::map<Resolution, ProfileChain> worn;
  for (const auto& [other, computation] : computed.all) {
    known[other] = {};
    if (!computation.failure.empty()) continue;
    known[other] = quantities_of(computation.fe, units, limits);
    if (wear.ends_in_limit() && !(fe.end.is_shared && computation.fe.end.is_shared))
      known[other][Quantity::worn_volume] *=
          volume_beyond(stick_radius_of(fe)) / volume_beyond(stick_radius_of(computation.fe));
    worn[other] = chain_of(computation.fe, computation.fe.end.worn, units.depth / limits.shakedown.maximum_indentation);
  }
  auto budget = error_budget(resolution, variants, known, {{Quantity::worn_radius, fe.worn_radius_uncertainty}}, needs);
  const auto between = [&worn](const Resolution& finer, const Resolution& coarser) {
    const auto a = worn.find(finer), b = worn.find(coarser);
    return a == worn.end() || b == worn.end() ? std::numeric_limits<double>::quiet_NaN()
                                              : distance_between(b->second, a->second);
  };
  budget[Quantity::distance_to_limit] = error_bar(Quantity::distance_to_limit, variants, between, needs);
  const double edge = stick_radius_error(prepared, fe, unworn_stick_radius), stick_radius = stick_radius_of(fe);
  budget[Quantity::distance_to_limit].add(ErrorSource::edge, edge);
  budget[Quantity::worn_volume].add(ErrorSource::edge,
                                    (volume_beyond(stick_radius - edge) / volume_beyond(stick_radius) - 1) *
                                        known.at(resolution).at(Quantity::worn_volume));
  if (wear.ends_in_limit()) add_stop(wear, units, budget);
  return budget;
}

/// The source to refine next: that of the largest share of the bar furthest above its tolerance, among what is
/// compared. Empty: no bar is above it.
std::optional<Resolution> finer(const PreparedCase& prepared, const ProvedWear& wear, const ErrorBudget& budget) {
  const ErrorShare* largest = nullptr;
  double furthest = 1;
  for (const auto& [quantity, bar] : budget) {
    const double tolerance = tolerance_of(prepared.tolerances, quantity), times = bar.total() / tolerance;
    if (!(times > 1) || !wear.limits.reached || (quantity != Quantity::worn_volume && !wear.ends_in_limit())) continue;
    log::detail(fmt::format("{}: {}", prepared.input.name, excess_text(quantity, bar, tolerance)));
    if (times <= furthest) continue;
    furthest = times;
    largest = bar.largest();
  }
  if (!largest || largest->source == ErrorSource::cycles) return std::nullopt;  // the case says when to stop
  constexpr double little = 1.5;  // what lacks; a share falls at least as its rings or steps become smaller
  const auto next = refined(wear.resolution, largest->source, furthest <= little ? little : 2);
  if (next) log::detail(fmt::format("{}: wear {}", prepared.input.name, change_text(wear.resolution, *next)));
  return next;
}

/// Force of pressures on the rings beyond a radius, up to a factor.
double force_beyond(const WearSimulation& wear, const Eigen::VectorXd& pressure, double radius) {
  double force = 0;
  for (Eigen::Index i = 0; i < pressure.size(); ++i)
    if (wear.centre[i] > radius) force += pressure[i] * (std::pow(wear.radii[i + 1], 2) - std::pow(wear.radii[i], 2));
  return force;
}

/// Takes a computation as the answer.
void take(const PreparedCase& prepared, double stick_radius, const WearComputation& computation, ProvedWear& wear) {
  wear.failure = computation.failure;
  wear.fe = computation.fe;
  if (!wear.failure.empty()) return;
  const auto& [first, last] = std::tie(wear.fe.course.first.largest_pressure, wear.fe.course.last.largest_pressure);
  const double close = tolerance_of(prepared.tolerances, Quantity::distance_to_limit);
  wear.pressed_outside = force_beyond(wear.fe, last, stick_radius + close) / force_beyond(wear.fe, first, 0);
}

/// Refines until the bars meet their tolerances.
ErrorBudget measure_errors(const PreparedCase& prepared, double stick_radius, Proof proof, WearComputations& computed,
                           ProvedWear& wear) {
  computed.compute(proof == Proof::none ? std::vector<Resolution>{wear.resolution} : needed_for_bars(wear.resolution));
  take(prepared, stick_radius, computed.all.at(wear.resolution), wear);
  for (int n = 0; proof != Proof::none && wear.failure.empty(); ++n) {
    computed.compute(needed_for_bars(wear.resolution));
    auto budget = budget_of(prepared, wear, stick_radius, computed);
    const bool goes_on = proof == Proof::tolerance && n < most_rounds;
    const auto next = goes_on ? finer(prepared, wear, budget) : std::nullopt;
    if (!next) return budget;
    computed.compute(needed_for_bars(*next));
    if (!computed.all.at(*next).failure.empty()) return budget;
    wear.resolution = *next;
    take(prepared, stick_radius, computed.all.at(*next), wear);
  }
  return {};
}

/// The course by springs; also empty where they do not become periodic.
std::optional<mdr::WearKinetics> springs_of(const PreparedCase& prepared, double n_cycles, int fineness = 1) {
  try {
    return wear_kinetics_of(prepared.input, prepared.mdr, n_cycles, fineness);
  } catch (const std::runtime_error& error) {
    log::detail(fmt::format("{}: no course of wear by springs: {}", prepared.input.name, error.what()));
    return std::nullopt;
  }
}

/// Volume after any number of cycles, between the points of a course.
double volume_after(const mdr::WearKinetics& kinetics, double cycles) {
  const auto& curve = kinetics.curve;
  const auto after =
      std::find_if(curve.begin(), curve.end(), [&](const auto& point) { return point.cycles >= cycles; });
  if (after == curve.begin()) return curve.front().volume;
  if (after == curve.end()) return curve.back().volume;
  const auto& before = *(after - 1);
  return before.volume + (after->volume - before.volume) * (cycles - before.cycles) / (after->cycles - before.cycles);
}

/// Largest error of the volume by springs along the course, over the volume of the limit: its difference from twice as
/// many springs in twice as many steps and jumps. Empty where these do not become periodic.
std::optional<double> error_of_springs(const PreparedCase& prepared, const ProvedWear& wear) {
  const auto finer = springs_of(prepared, wear.kinetics->curve.back().cycles, 2);
  if (!finer) return std::nullopt;
  double largest = 0;
  for (const auto& point : wear.kinetics->curve)
    largest = std::max(largest, std::abs(volume_after(*finer, point.cycles) - point.volume));
  return largest / wear.limits.shakedown.volume;
}

/// Whether nothing that touches slips, in either method.
bool sticks_throughout(const PreparedCase& prepared, const ProvedWear& wear) {
  if (wear.slip_is_proved) return false;
  const auto springs = springs_of(prepared, 1);
  return springs && springs->curve.back().volume == 0;
}

double largest_difference(const ProvedWear& wear, const Units& units) {
  double largest = 0;
  for (const auto& point : wear.fe.course.curve)
    largest = std::max(largest, std::abs(point.volume * units.volume() - volume_after(*wear.kinetics, point.cycles)));
  return largest / wear.limits.shakedown.volume;
}

/// Error bar of the last volume rate over that rate. Refinements end after other numbers of cycles, which matters
/// little: progressive wear hardly changes its rate any more.
ErrorBar bar_of_rate(const PreparedCase& prepared, const ProvedWear& wear, const WearComputations& computed) {
  const auto rate_of = [&computed](const Resolution& resolution) {
    const auto found = computed.all.find(resolution);
    return found == computed.all.end() || !found->second.failure.empty()
               ? std::numeric_limits<double>::quiet_NaN()
               : found->second.fe.course.curve.back().volume_rate;
  };
  const double rate = rate_of(wear.resolution);
  return error_bar(
      Quantity::worn_volume, variants_of_wear(wear.resolution),
      [&](const Resolution& finer, const Resolution& coarser) { return (rate_of(finer) - rate_of(coarser)) / rate; },
      needs_of_wear(prepared.fem));
}

/// Whether friction takes more energy than its error bar, as far as there is one.
bool slip_is_proved(const ProvedAnswer& unworn) {
  const auto bar = unworn.budget.find(Quantity::friction_work);
  if (bar == unworn.budget.end() || !unworn.fe.cycle) return true;
  return unworn.fe.cycle->value(Quantity::friction_work) > bar->second.total() * unworn.fe.cycle->sliding_work;
}

Comparison compare(const PreparedCase& prepared, const ProvedWear& wear, const ErrorBudget& budget) {
  const auto& units = prepared.fem.units;
  auto values = quantities_of(wear.fe, units, wear.limits);
  values[Quantity::distance_to_limit] = wear.distance_shakedown.back();
  Comparison comparison;
  if (!wear.slip_is_proved && !wear.sticks_throughout) return comparison;
  const auto judge = [&](Quantity quantity, double expected, double error = 0) {
    Difference one{values.at(quantity) - expected, tolerance_of(prepared.tolerances, quantity)};
    if (const auto bar = budget.find(quantity); bar != budget.end()) one.bar = bar->second;
    one.mdr_error = error;
    comparison[quantity] = judged(one);
  };
  if (!wear.ends_in_limit()) {
    if (wear.springs_error)
      judge(Quantity::worn_volume, wear.kinetics->curve.back().volume / wear.limits.shakedown.volume,
            *wear.springs_error);
    return comparison;
  }
  if (!wear.limits.reached) return comparison;
  judge(Quantity::worn_volume, 1);
  judge(Quantity::worn_radius, wear.limits.shakedown.outer_radius / units.length);
  judge(Quantity::distance_to_limit, 0);
  return comparison;
}

/// Whether an indenter that has worn before can still end in a limiting profile: it is worn nowhere deeper than that,
/// within the tolerance of the distance in either direction.
bool may_still_reach(const PreparedCase& prepared, const WearLimit& limit) {
  const auto& fem = prepared.fem;
  if (!fem.worn_before) return true;
  const double tolerance = tolerance_of(prepared.tolerances, Quantity::distance_to_limit), step = tolerance / 2,
               unit = fem.units.depth / limit.maximum_indentation;
  for (double r = 0; r < 2 * limit.outer_radius / fem.units.length; r += step) {
    const double height = unit * (fem.profile(r) + fem.worn_before->depth(r)),
                 allowed = limit.height((r + tolerance) * fem.units.length) / limit.maximum_indentation;
    if (height > allowed + tolerance) return false;
  }
  return true;
}

}  // namespace

bool ProvedWear::ends_in_limit() const {
  const auto end = fe.course.end;
  return (end == fem::WearEnd::rate || end == fem::WearEnd::nothing_left) && pressed_outside < fem::as_good_as_nothing;
}

bool wears(const PreparedCase& prepared) {
  return prepared.input.wear_kinetics && prepared.fem.body.tangential;
}

ProvedWear prove_wear(const PreparedCase& prepared, const MdrAnswer& mdr, const ProvedAnswer& unworn, Proof proof,
                      BodyStore& bodies, const WearOversight& oversight) {
  const auto& units = prepared.fem.units;
  ProvedWear wear{{}, {}, resolution_for_wear(prepared.fem.resolution), wear_limits(prepared.mdr, mdr)};
  wear.limits.reached = wear.limits.reached && may_still_reach(prepared, wear.limits.shakedown);
  const auto edge = attempted([&] {
    return edge_of_wear(prepared.fem, *prepared.input.wear_kinetics,
                        unworn.fe.stick_radius_shakedown.value_or(0) / units.length, bodies, {oversight.checkpoints});
  });
  wear.failure = edge.failure;
  if (!wear.failure.empty()) return wear;
  WearComputations computed(prepared, edge.fe, wear.limits, bodies, oversight);
  wear.slip_is_proved = slip_is_proved(unworn);
  wear.sticks_throughout = sticks_throughout(prepared, wear);
  const bool known = wear.slip_is_proved || wear.sticks_throughout;
  const auto budget = measure_errors(prepared, edge.fe.inner, known ? proof : Proof::none, computed, wear);
  wear.cost = computed.cost();
  wear.cost.seconds += edge.seconds;
  if (!wear.failure.empty()) return wear;
  if (!prepared.mdr.has_forces()) wear.kinetics = springs_of(prepared, wear.fe.course.curve.back().cycles);
  wear.distance_shakedown = distances_of(wear.fe, units, wear.limits.shakedown);
  wear.distance_first_slip = distances_of(wear.fe, units, wear.limits.first_slip);
  if (wear.kinetics) wear.largest_springs_difference = largest_difference(wear, units);
  if (wear.fe.course.end == fem::WearEnd::progressive && proof != Proof::none)
    wear.rate_error = bar_of_rate(prepared, wear, computed).total();
  if (wear.kinetics && known && !wear.ends_in_limit()) wear.springs_error = error_of_springs(prepared, wear);
  wear.comparison = compare(prepared, wear, budget);
  return wear;
}

}  // namespace fretval
