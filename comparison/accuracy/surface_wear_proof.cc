#include "comparison/accuracy/surface_wear_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "comparison/support/log.h"
#include "comparison/support/parallel.h"

namespace fretval {
namespace {

struct Coarser {
  ErrorSource source;
  Resolution resolution;
};

std::vector<Coarser> coarser_than(const Resolution& resolution) {
  Resolution jumps = resolution;
  jumps.wear_jump *= 2;
  return {{ErrorSource::rings, with_rings(resolution, 0.5)},
          {ErrorSource::time_step, with_steps(resolution, 0.5)},
          {ErrorSource::angles, with_angles(resolution, 0.5)},
          {ErrorSource::wear_jump, jumps}};
}

double volume_of(const SurfaceWear& fe) {
  return fe.course.curve.back().volume;
}

/// Adds the differences from a coarser computation to the bars, as the share of a source.
void add_share(ErrorSource source, const SurfaceWear& coarse, ProvedSurfaceWear& wear) {
  const auto &fine = wear.fe.sticks, &other = coarse.sticks;
  wear.radius.add(source, std::abs(fine.radius - other.radius));
  wear.along.add(source, std::abs(fine.along - other.along));
  wear.across.add(source, std::abs(fine.across - other.across));
  wear.volume.add(source, std::abs(volume_of(coarse) / volume_of(wear.fe) - 1));
}

}  // namespace

ProvedSurfaceWear prove_surface_wear(const PreparedCase& prepared, const MdrAnswer& mdr, const ProvedAnswer& unworn,
                                     Proof proof, BodyStore& bodies, const WearOversight& oversight) {
  const auto& fem = prepared.fem;
  ProvedSurfaceWear wear{
      {}, {}, resolution_for_surface_wear(prepared.input, fem.resolution), wear_limits(prepared.mdr, mdr).shakedown};
  std::vector<Resolution> wanted{wear.resolution};
  const auto coarser = coarser_than(wear.resolution);
  if (proof != Proof::none)
    for (const auto& one : coarser) wanted.push_back(one.resolution);
  const auto edge = attempted([&] {
    return edge_of_surface_wear(fem, *prepared.input.wear_kinetics,
                                unworn.fe.stick_radius_shakedown.value_or(0) / fem.units.length, wear.resolution,
                                bodies, oversight.checkpoints);
  });
  wear.failure = edge.failure;
  wear.cost.seconds = edge.seconds;
  if (!wear.failure.empty()) return wear;
  std::vector<Computed<SurfaceWear>> made(wanted.size());
  std::mutex mutex;
  const auto told = [&](const fem::WearCourse& course) {
    if (!oversight.progress) return;
    const std::lock_guard<std::mutex> lock(mutex);
    const double share = course.curve.back().volume * fem.units.volume() / wear.limit.volume;
    oversight.progress(std::min(share, 1.0), course.curve.back().stick_radius);
  };
  for_each_in_parallel(wanted.size(), [&](std::size_t i) {
    const auto nothing = [](const fem::WearCourse&) {};
    made[i] = attempted([&] {
      return simulate_surface_wear(fem, *prepared.input.wear_kinetics, edge.fe, wanted[i], bodies,
                                   oversight.checkpoints,
                                   i == 0 ? std::function<void(const fem::WearCourse&)>(told) : nothing);
    });
  });
  for (std::size_t i = 0; i < made.size(); ++i) {
    const long n_cycles = made[i].fe.course.n_cycles_stepped;
    wear.cost = wear.cost + ProofCost{1, n_cycles * wanted[i].steps_per_cycle, n_cycles, made[i].seconds};
    if (wear.failure.empty()) wear.failure = made[i].failure;
  }
  wear.fe = std::move(made.front().fe);
  if (!wear.failure.empty() || proof == Proof::none) return wear;
  for (std::size_t i = 1; i < made.size(); ++i) {
    if (made[i].fe.course.end == wear.fe.course.end) continue;
    log::warn(fmt::format("{}: wear ends in another way where the {} is coarser: it has no error bars",
                          prepared.input.name, name_of(coarser[i - 1].source)));
    return wear;
  }
  wear.is_proved = true;
  for (std::size_t i = 1; i < made.size(); ++i) add_share(coarser[i - 1].source, made[i].fe, wear);
  wear.radius.add(ErrorSource::edge, wear.fe.sticks.uncertainty);
  for (auto* bar : {&wear.along, &wear.across}) bar->add(ErrorSource::edge, wear.fe.sticks.edge_uncertainty);
  const auto& curve = wear.fe.course.curve;
  if (curve.size() > 1) wear.volume.add(ErrorSource::cycles, 1 - (curve.end() - 2)->volume / curve.back().volume);
  return wear;
}

}  // namespace fretval
