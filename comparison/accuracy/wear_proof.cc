#include "comparison/accuracy/wear_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/accuracy/distance_to_limit.h"
#include "comparison/support/log.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

constexpr int most_rounds = 3;

struct WearComputation {
  WearSimulation fe;
  std::string failure = {};
};

/// The wear of a case at all the resolutions that are asked for, each computed once.
class WearComputations {
 public:
  WearComputations(const PreparedCase& prepared, double stick_radius, BodyStore& bodies)
      : prepared_(prepared), stick_radius_(stick_radius), bodies_(bodies) {}

  void compute(const std::vector<Resolution>& wanted) {
    std::vector<Resolution> missing;
    for (const auto& resolution : wanted)
      if (all.try_emplace(resolution).second) missing.push_back(resolution);
    for_each_in_parallel(missing.size(), [&](std::size_t i) { all.at(missing[i]) = attempt(missing[i]); });
  }

  std::map<Resolution, WearComputation> all;

 private:
  [[nodiscard]] WearComputation attempt(const Resolution& resolution) const {
    try {
      return {simulate_wear(prepared_.fem, *prepared_.input.wear_kinetics, stick_radius_, resolution, bodies_)};
    } catch (const fem::SolverError& error) {
      return {{}, error.what()};
    } catch (const meshes::MeshError& error) {
      return {{}, error.what()};
    }
  }

  const PreparedCase& prepared_;
  double stick_radius_;
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

double distance_of(const WearSimulation& wear, const Units& units, const mdr::LimitingProfile& limit) {
  return distance_to_limit(limit, units.length, units.length * wear.centre,
                           units.depth * (wear.unworn + wear.course.worn.back()));
}

Quantities quantities_of(const WearSimulation& wear, const Units& units, const WearLimits& limits) {
  return {
      {Quantity::worn_volume, wear.course.curve.back().volume * units.volume() / mdr::worn_volume(limits.shakedown)},
      {Quantity::worn_radius, wear.worn_radius},
      {Quantity::distance_to_limit, distance_of(wear, units, limits.shakedown)}};
}

ErrorBudget budget_of(const PreparedCase& prepared, const WearLimits& limits, const Resolution& resolution,
                      const WearComputations& computed) {
  std::map<Resolution, Quantities> known;
  for (const auto& [other, computation] : computed.all)
    known[other] =
        computation.failure.empty() ? quantities_of(computation.fe, prepared.fem.units, limits) : Quantities{};
  return error_budget(resolution, variants_of_wear(resolution), known, {}, {prepared.fem.relaxation.has_memory()});
}

/// What is refined next: the largest share of the bar that is furthest above its tolerance. Empty: none is.
std::optional<Resolution> finer(const PreparedCase& prepared, const Resolution& resolution, const ErrorBudget& budget) {
  const ErrorShare* largest = nullptr;
  double furthest = 1;
  for (const auto& [quantity, bar] : budget) {
    const double times = bar.total() / tolerance_of(prepared.tolerances, quantity);
    if (!(times > furthest)) continue;
    furthest = times;
    largest = bar.largest();
  }
  if (!largest) return std::nullopt;
  const auto next = refined(resolution, largest->source);
  if (next)
    log::info(fmt::format("{}: an error bar of the wear is {:.1f} times the tolerance: from {} to {}",
                          prepared.input.name, furthest, text_of(resolution), text_of(*next)));
  return next;
}

/// Refines until the bars meet their tolerances.
ErrorBudget measure_errors(const PreparedCase& prepared, Proof proof, WearComputations& computed, ProvedWear& wear) {
  computed.compute({wear.resolution});
  for (int n = 0; proof != Proof::none; ++n) {
    computed.compute(needed_for_bars(wear.resolution));
    auto budget = budget_of(prepared, wear.limits, wear.resolution, computed);
    const bool goes_on = proof == Proof::tolerance && n < most_rounds;
    const auto next = goes_on ? finer(prepared, wear.resolution, budget) : std::nullopt;
    if (!next) return budget;
    computed.compute({*next});
    if (!computed.all.at(*next).failure.empty()) return budget;
    wear.resolution = *next;
  }
  return {};
}

double share_pressed_outside(const WearSimulation& wear, double stick_radius) {
  const auto& pressure = wear.course.last.largest_pressure;
  double outside = 0, all = 0;
  for (Eigen::Index i = 0; i < pressure.size(); ++i) {
    const double force = pressure[i] * (std::pow(wear.radii[i + 1], 2) - std::pow(wear.radii[i], 2));
    all += force;
    if (wear.centre[i] > stick_radius) outside += force;
  }
  return all > 0 ? outside / all : 0;
}

/// Where wear has ended in its limit, that; otherwise the springs' course, if they have it.
std::optional<double> reference_volume(const ProvedWear& wear) {
  if (wear.ends_in_limit()) return mdr::worn_volume(wear.limits.shakedown);
  return wear.kinetics ? std::optional(wear.kinetics->curve.back().volume) : std::nullopt;
}

Comparison compare(const PreparedCase& prepared, const ProvedWear& wear, const ErrorBudget& budget) {
  const auto& units = prepared.fem.units;
  const auto values = quantities_of(wear.fe, units, wear.limits);
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
  if (const auto volume = reference_volume(wear))
    judge(Quantity::worn_volume, *volume / mdr::worn_volume(wear.limits.shakedown));
  if (!wear.ends_in_limit()) return comparison;
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
  const double stick_radius = unworn.fe.stick_radius_shakedown.value_or(0) / units.length;
  ProvedWear wear{{}, {}, resolution_for_wear(prepared.fem.resolution), wear_limits(prepared.mdr, mdr)};
  WearComputations computed(prepared, stick_radius, bodies);
  const auto budget = measure_errors(prepared, proof, computed, wear);
  wear.n_computations = static_cast<int>(computed.all.size());
  wear.failure = computed.all.at(wear.resolution).failure;
  if (!wear.failure.empty()) return wear;
  wear.fe = std::move(computed.all.at(wear.resolution).fe);
  wear.kinetics = wear_kinetics_of(prepared.input, prepared.mdr, wear.fe.course.curve.back().cycles);
  wear.distance_shakedown = distance_of(wear.fe, units, wear.limits.shakedown);
  wear.distance_first_slip = distance_of(wear.fe, units, wear.limits.first_slip);
  wear.pressed_outside = share_pressed_outside(wear.fe, stick_radius);
  wear.comparison = compare(prepared, wear, budget);
  return wear;
}

}  // namespace fretval
