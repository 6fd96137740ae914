#include "comparison/run/estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparison/accuracy/error_bars.h"
#include "comparison/accuracy/refinement.h"
#include "comparison/accuracy/wear_proof.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/simulation/wear_simulation.h"

namespace fretval {
namespace {

constexpr double of_a_body = 0.2, of_a_history = 0.05;  // s at 32 rings and 72 steps
constexpr double of_more_rings = 1.7;  // power of the rings that a history goes with; a body with the first
constexpr double of_a_variant = 0.5;   // coarser than the resolution that it belongs to
constexpr double until_the_tolerance_is_met = 1.5;  // some bars are wider at first
constexpr double of_a_force = 2.5;                  // steps under a force are solved for more than once
constexpr double of_a_wear = 0.45;                  // s at 32 rings and 72 steps, to the end of the wear
constexpr double of_a_wear_variant = 0.3;
constexpr double proved_by_the_first_rings = 1e-3;  // a tolerance; finer ones refine the wear twice

double relative_rings(const Resolution& r) {
  return r.elements_per_radius / 32.0;
}

double relative_steps(const Resolution& r, int highest_order) {
  return r.steps_per_cycle * highest_order / 72.0;
}

double seconds_of_wear(const PreparedCase& prepared, Proof proof) {
  const auto resolution = resolution_for_wear(prepared.fem.resolution);
  const auto n_variants = proof == Proof::none ? 0.0 : static_cast<double>(variants_of_wear(resolution).size());
  const double refined = proof == Proof::tolerance
                             ? std::pow(std::max(1.0, proved_by_the_first_rings / prepared.input.tolerance), 1.5)
                             : 1;
  return of_a_wear * refined * (1 + of_a_wear_variant * n_variants) * std::pow(relative_rings(resolution), 2) *
         relative_steps(resolution, prepared.fem.motion.highest_order());
}

}  // namespace

double seconds_of_one(const Resolution& resolution, int highest_order, std::size_t n_sharing) {
  const double rings = relative_rings(resolution);
  return of_a_body * rings / static_cast<double>(n_sharing) +
         of_a_history * std::pow(rings, of_more_rings) * relative_steps(resolution, highest_order);
}

double estimated_seconds(const Resolution& resolution, int highest_order, std::size_t n_computations,
                         std::size_t n_sharing) {
  return of_a_variant * static_cast<double>(n_computations) * seconds_of_one(resolution, highest_order, n_sharing);
}

bool slides(const PreparedCase& prepared) {
  const auto share = steady_sliding_share(prepared.mdr);
  return share && *share < 1;
}

double estimated_seconds(const PreparedCase& prepared, Proof proof, std::size_t n_sharing) {
  if (slides(prepared)) proof = Proof::none;
  const auto n = proof == Proof::none ? 2 : computations_for_bars(prepared.fem);  // 2: the whole of one
  const double seconds = estimated_seconds(prepared.fem.resolution, prepared.fem.motion.highest_order(), n, n_sharing) *
                         (proof == Proof::tolerance ? until_the_tolerance_is_met : 1) *
                         (prepared.mdr.has_forces() ? of_a_force : 1);
  return wears(prepared) ? seconds + seconds_of_wear(prepared, proof) : seconds;
}

std::map<std::string, double> estimated_seconds(const std::vector<PreparedCase>& cases, Proof proof,
                                                std::size_t n_cores) {
  std::map<std::string, double> seconds;
  std::map<BodyDescription, std::size_t> n_sharing;
  for (const auto& one : cases) ++n_sharing[one.fem.body];
  for (const auto& one : cases)
    seconds[one.input.name] = estimated_seconds(one, proof, n_sharing.at(one.fem.body)) / static_cast<double>(n_cores);
  return seconds;
}

std::vector<std::size_t> longest_first(const std::vector<PreparedCase>& cases, Proof proof) {
  const auto seconds = estimated_seconds(cases, proof, 1);
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return seconds.at(cases[i].input.name) > seconds.at(cases[j].input.name);
  });
  return order;
}

std::size_t computations_for_bars(const FemCase& fem) {
  return 1 + variants_of(fem.resolution, needs_of(fem)).size();
}

}  // namespace fretval
