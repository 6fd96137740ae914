#include "comparison/accuracy/wear_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "comparison/accuracy/distance_to_limit.h"
#include "comparison/support/log.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

constexpr int most_rounds = 2;

struct WearComputation {
  WearSimulation fe;
  std::string failure = {};
};

/// The wear of a case at all the resolutions that are asked for, each computed once.
class WearComputations {
 public:
  WearComputations(const PreparedCase& prepared, const WornEdge& edge, BodyStore& bodies)
      : prepared_(prepared), edge_(edge), bodies_(bodies) {}

  void compute(const std::vector<Resolution>& wanted) {
    std::vector<Resolution> missing;
    for (const auto& resolution : wanted)
      if (all.try_emplace(resolution).second) missing.push_back(resolution);
    for_each_in_parallel(missing.size(), [&](std::size_t i) { all.at(missing[i]) = attempt(missing[i]); });
  }

  [[nodiscard]] BodyCount bodies() const {
    std::vector<std::shared_ptr<const BodySummary>> bodies;
    for (const auto& [resolution, computation] : all) bodies.push_back(computation.fe.body);
    return count_of(bodies);
  }

  std::map<Resolution, WearComputation> all;

 private:
  [[nodiscard]] WearComputation attempt(const Resolution& resolution) const {
    try {
      return {simulate_wear(prepared_.fem, *prepared_.input.wear_kinetics, edge_, resolution, bodies_)};
    } catch (const fem::SolverError& error) {
      return {{}, error.what()};
    } catch (const meshes::MeshError& error) {
      return {{}, error.what()};
    }
  }

  const PreparedCase& prepared_;
  WornEdge edge_;
  BodyStore& bodies_;
};

std::vector<Resolution> needed_for_bars(const Resolution& resolution) {
  std::vector<Resolution> needed;
  for (const auto& variant : variants_of_wear(resolution)) {
    needed.push_back(variant.reference);
    needed.push_back(variant.resolution);
  }
  return needed;
}

ProfileChain worn_chain(const WearSimulation& wear, const Eigen::VectorXd& worn, const Units& units, double deepest) {
  ProfileChain chain;
  for (Eigen::Index i = 0; i < worn.size(); ++i)
    chain.emplace_back(wear.centre[i], units.depth * (wear.unworn[i] + worn[i]) / deepest);
  return chain;
}

ProfileChain limit_of(const WearSimulation& wear, const Units& units, const mdr::LimitingProfile& limit) {
  return chain_of(limit, units.length, units.length * wear.radii.back());
}

/// Of the profiles of a course from a limit.
std::vector<double> distances(const WearSimulation& wear, const Units& units, const mdr::LimitingProfile& limit) {
  const auto chain = limit_of(wear, units, limit);
  std::vector<double> distances;
  for (const auto& worn : wear.course.worn)
    distances.push_back(distance_between(worn_chain(wear, worn, units, limit.maximum_indentation), chain));
  return distances;
}

Quantities quantities_of(const WearSimulation& wear, const Units& units, const WearLimits& limits) {
  return {
      {Quantity::worn_volume, wear.course.curve.back().volume * units.volume() / mdr::worn_volume(limits.shakedown)},
      {Quantity::worn_radius, wear.worn_radius}};
}

/// A ring slips as a whole, or not at all: the stick radius, if there is one, is known to the width of the rings at it.
double edge_ring(const WearSimulation& wear) {
  const double stick_radius = wear.course.curve.back().stick_radius;
  const auto rings = rings_at(wear.radii, stick_radius);
  return stick_radius > 0 ? std::max(rings.inside, rings.outside) : 0;
}

/// The share of the worn volume that one of the stick radius makes: the volume vanishes like (a - c)^(5/2) as c reaches
/// the contact radius, and depends on smaller c less.
double volume_per_stick_radius(const WearSimulation& wear) {
  const auto& [first, last] = std::tie(wear.course.curve.front(), wear.course.curve.back());
  const double outside = first.contact_radius - last.stick_radius;
  return outside > 0 ? 2.5 / outside : 0;
}

ErrorBudget budget_of(const PreparedCase& prepared, const WearLimits& limits, const Resolution& resolution,
                      const WearComputations& computed) {
  const auto& units = prepared.fem.units;
  const auto variants = variants_of_wear(resolution);
  const CaseNeeds needs{prepared.fem.relaxation.has_memory()};
  std::map<Resolution, Quantities> known;
  std::map<Resolution, ProfileChain> worn;
  for (const auto& [other, computation] : computed.all) {
    known[other] = {};
    if (!computation.failure.empty()) continue;
    known[other] = quantities_of(computation.fe, units, limits);
    worn[other] =
        worn_chain(computation.fe, computation.fe.course.worn.back(), units, limits.shakedown.maximum_indentation);
  }
  auto budget = error_budget(resolution, variants, known,
                             {{Quantity::worn_radius, computed.all.at(resolution).fe.worn_radius_uncertainty}}, needs);
  const auto between = [&worn](const Resolution& finer, const Resolution& coarser) {
    const auto a = worn.find(finer), b = worn.find(coarser);
    return a == worn.end() || b == worn.end() ? std::numeric_limits<double>::quiet_NaN()
                                              : distance_between(b->second, a->second);
  };
  budget[Quantity::distance_to_limit] = error_bar(Quantity::distance_to_limit, variants, between, needs);
  const auto& [fe, failure] = computed.all.at(resolution);
  const double edge = edge_ring(fe);
  budget[Quantity::distance_to_limit].add(ErrorSource::edge, edge);
  budget[Quantity::worn_volume].add(
      ErrorSource::edge, edge * volume_per_stick_radius(fe) * known.at(resolution).at(Quantity::worn_volume));
  return budget;
}

/// What is refined next: the largest share of the bar that is furthest above its tolerance, of what is compared. Empty:
/// none is.
std::optional<Resolution> finer(const PreparedCase& prepared, const ProvedWear& wear, const ErrorBudget& budget) {
  const ErrorShare* largest = nullptr;
  double furthest = 1;
  for (const auto& [quantity, bar] : budget) {
    const double times = bar.total() / tolerance_of(prepared.tolerances, quantity);
    if (!(times > furthest) || !wear.limits.reached || (quantity != Quantity::worn_volume && !wear.ends_in_limit()))
      continue;
    furthest = times;
    largest = bar.largest();
  }
  if (!largest) return std::nullopt;
  const auto next = refined(wear.resolution, largest->source);
  if (next)
    log::info(fmt::format("{}: an error bar of the wear is {:.1f} times the tolerance; refined: {}",
                          prepared.input.name, furthest, name_of(largest->source)));
  return next;
}

/// Force of pressures on the rings beyond a radius, up to a factor.
double force_beyond(const WearSimulation& wear, const Eigen::VectorXd& pressure, double radius) {
  double force = 0;
  for (Eigen::Index i = 0; i < pressure.size(); ++i)
    if (wear.centre[i] > radius) force += pressure[i] * (std::pow(wear.radii[i + 1], 2) - std::pow(wear.radii[i], 2));
  return force;
}

/// Takes a computation for the answer.
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
  computed.compute({wear.resolution});
  take(prepared, stick_radius, computed.all.at(wear.resolution), wear);
  for (int n = 0; proof != Proof::none && wear.failure.empty(); ++n) {
    computed.compute(needed_for_bars(wear.resolution));
    auto budget = budget_of(prepared, wear.limits, wear.resolution, computed);
    const bool goes_on = proof == Proof::tolerance && n < most_rounds;
    const auto next = goes_on ? finer(prepared, wear, budget) : std::nullopt;
    if (!next) return budget;
    computed.compute({*next});
    if (!computed.all.at(*next).failure.empty()) return budget;
    wear.resolution = *next;
    take(prepared, stick_radius, computed.all.at(*next), wear);
  }
  return {};
}

/// The course by springs; also empty where they do not become periodic.
std::optional<mdr::WearKinetics> springs_of(const PreparedCase& prepared, double n_cycles,
                                            int steps_per_cycle = mdr::WearControl{}.steps_per_cycle) {
  try {
    return wear_kinetics_of(prepared.input, prepared.mdr, n_cycles, steps_per_cycle);
  } catch (const std::runtime_error& error) {
    log::info(fmt::format("{}: no course of wear by springs: {}", prepared.input.name, error.what()));
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

/// Whether springs of twice as many steps wear off as much in the course, to a hundredth, of which the jumps of either
/// are. Where everything that touches sticks, they slip by what their time steps are off, and in many cycles that
/// wears: their friction work falls with the square of the step.
bool springs_agree(const PreparedCase& prepared, const ProvedWear& wear) {
  constexpr double share = 1e-2;
  const auto finer = springs_of(prepared, wear.kinetics->curve.back().cycles, 2 * mdr::WearControl{}.steps_per_cycle);
  const double allowed = share * mdr::worn_volume(wear.limits.shakedown);
  return finer && std::all_of(wear.kinetics->curve.begin(), wear.kinetics->curve.end(), [&](const auto& point) {
           return std::abs(volume_after(*finer, point.cycles) - point.volume) <= allowed;
         });
}

Comparison compare(const PreparedCase& prepared, const ProvedWear& wear, const ErrorBudget& budget) {
  const auto& units = prepared.fem.units;
  auto values = quantities_of(wear.fe, units, wear.limits);
  values[Quantity::distance_to_limit] = wear.distance_shakedown.back();
  Comparison comparison;
  const auto judge = [&](Quantity quantity, double expected) {
    const double difference = values.at(quantity) - expected, tolerance = tolerance_of(prepared.tolerances, quantity);
    const auto bar = budget.find(quantity);
    if (bar == budget.end())
      comparison[quantity] = {difference, tolerance, verdict_on(difference, tolerance)};
    else
      comparison[quantity] = {difference, tolerance, verdict_on(difference, tolerance, bar->second.total()),
                              bar->second};
  };
  if (!wear.ends_in_limit()) {
    if (wear.kinetics && wear.springs_agree)
      judge(Quantity::worn_volume, wear.kinetics->curve.back().volume / mdr::worn_volume(wear.limits.shakedown));
    return comparison;
  }
  if (!wear.limits.reached) return comparison;
  judge(Quantity::worn_volume, 1);
  judge(Quantity::worn_radius, wear.limits.shakedown.outer_radius / units.length);
  judge(Quantity::distance_to_limit, 0);
  return comparison;
}

}  // namespace

bool ProvedWear::ends_in_limit() const {
  constexpr double nothing = 1e-2;  // a contact that sticks throughout bears tens of percent there
  return fe.course.end != fem::WearEnd::cycles && pressed_outside < nothing;
}

bool wears(const PreparedCase& prepared) {
  return prepared.input.wear_kinetics && prepared.fem.body.tangential;
}

ProvedWear prove_wear(const PreparedCase& prepared, const MdrAnswer& mdr, const ProvedAnswer& unworn, Proof proof,
                      BodyStore& bodies) {
  const auto& units = prepared.fem.units;
  ProvedWear wear{{}, {}, resolution_for_wear(prepared.fem.resolution), wear_limits(prepared.mdr, mdr)};
  WornEdge edge{};
  try {
    edge = edge_of_wear(prepared.fem, *prepared.input.wear_kinetics,
                        unworn.fe.stick_radius_shakedown.value_or(0) / units.length, bodies);
  } catch (const fem::SolverError& error) {
    wear.failure = error.what();
    return wear;
  }
  WearComputations computed(prepared, edge, bodies);
  const auto budget = measure_errors(prepared, edge.inner, proof, computed, wear);
  wear.n_computations = static_cast<int>(computed.all.size());
  wear.bodies = computed.bodies();
  if (!wear.failure.empty()) return wear;
  if (!prepared.mdr.has_forces()) wear.kinetics = springs_of(prepared, wear.fe.course.curve.back().cycles);
  wear.distance_shakedown = distances(wear.fe, units, wear.limits.shakedown);
  wear.distance_first_slip = distances(wear.fe, units, wear.limits.first_slip);
  wear.springs_agree = wear.kinetics && (wear.ends_in_limit() || springs_agree(prepared, wear));
  wear.comparison = compare(prepared, wear, budget);
  return wear;
}

}  // namespace fretval
