#include "comparison/accuracy/wear_computations.h"

#include <algorithm>
#include <cmath>

#include "comparison/support/parallel.h"

namespace fretval {
namespace {

/// Expected work of a computation of wear, up to a factor.
double expected_work(const Resolution& r) {
  return std::pow(r.elements_per_radius, 2) * r.steps_per_cycle / r.wear_jump;
}

/// A limit as far out as the rings reach.
ProfileChain limit_of(const WearSimulation& wear, const Units& units, const WearLimit& limit) {
  return chain_of(limit, units.length, units.length * wear.radii.back());
}

/// Worn depth at the centre of a ring, from the means of the rings. Over its area, r^2, the mean is off by a 24th of
/// the second difference. Next to the edges, where that is no small part of the depth, the mean stands.
double depth_at_centre(const WearSimulation& wear, const Eigen::VectorXd& worn, Eigen::Index i) {
  constexpr double small_part = 0.1;
  if (i == 0 || i + 1 >= worn.size() || worn.segment(i - 1, 3).minCoeff() <= 0) return worn[i];
  const auto squares_apart = [](double from, double to) { return (to - from) * (to + from); };
  const auto ring = static_cast<std::size_t>(i);
  const double before = squares_apart(wear.centre[i - 1], wear.centre[i]),
               after = squares_apart(wear.centre[i], wear.centre[i + 1]),
               area = squares_apart(wear.radii[ring], wear.radii[ring + 1]);
  const double bend = 2 * ((worn[i + 1] - worn[i]) / after - (worn[i] - worn[i - 1]) / before) / (before + after),
               off = area * area * bend / 24;
  return std::abs(off) < small_part * worn[i] ? worn[i] - off : worn[i];
}

}  // namespace

ProfileChain chain_of(const WearSimulation& wear, const Eigen::VectorXd& worn, double unit) {
  ProfileChain chain;
  for (Eigen::Index i = 0; i < worn.size(); ++i)
    chain.emplace_back(wear.centre[i], unit * (wear.unworn[i] + depth_at_centre(wear, worn, i)));
  return chain;
}

std::vector<double> distances_of(const WearSimulation& wear, const Units& units, const WearLimit& limit) {
  const auto chain = limit_of(wear, units, limit);
  std::vector<double> distances;
  const auto add = [&](const Eigen::VectorXd& worn) {
    distances.push_back(distance_between(chain_of(wear, worn, units.depth / limit.maximum_indentation), chain));
  };
  for (std::size_t i = 0; i + 1 < wear.course.worn.size(); ++i) add(wear.course.worn[i]);
  add(wear.end.worn);
  return distances;
}

void WearComputations::compute(const std::vector<Resolution>& wanted) {
  std::vector<Resolution> missing;
  for (const auto& resolution : wanted)
    if (all.try_emplace(resolution).second) missing.push_back(resolution);
  // The longest computation begins first, and the others go on beside it.
  std::sort(missing.begin(), missing.end(),
            [](const auto& a, const auto& b) { return expected_work(a) > expected_work(b); });
  for (const auto& resolution : missing) shares_.try_emplace(resolution, 0.0);
  for_each_in_parallel(missing.size(), [&](std::size_t i) { all.at(missing[i]) = attempt(missing[i]); });
}

ProofCost WearComputations::cost() const {
  ProofCost cost{static_cast<int>(all.size()), 0, 0, 0, count_bodies_of(all)};
  for (const auto& [resolution, computation] : all) {
    const long n_cycles = computation.fe.course.n_cycles_stepped;
    cost.cycles += n_cycles;
    cost.time_steps += n_cycles * at_resolution(prepared_.fem, resolution).steps_per_cycle();
    cost.seconds += computation.seconds;
  }
  return cost;
}

WearComputation WearComputations::attempt(const Resolution& resolution) {
  WearRun run{oversight_.checkpoints};
  const auto& wear = *prepared_.input.wear_kinetics;
  const auto& units = prepared_.fem.units;
  const auto& limit = limits_.shakedown;
  if (oversight_.progress)
    run.progress = [&, chain = ProfileChain(), all_of_it = limit.volume](const WearSimulation& rings,
                                                                         const fem::WearCourse& course) mutable {
      if (chain.empty()) chain = limit_of(rings, units, limit);
      const auto& point = course.curve.back();
      const double by_volume = point.volume * units.volume() / all_of_it,
                   by_cycles = wear.n_cycles ? point.cycles / *wear.n_cycles : 0;
      const auto worn = chain_of(rings, course.worn.back(), units.depth / limit.maximum_indentation);
      tell(resolution, std::min(std::max(by_volume, by_cycles), 1.0), distance_between(worn, chain));
    };
  return attempted([&] { return simulate_wear(prepared_.fem, wear, edge_, resolution, bodies_, run); });
}

void WearComputations::tell(const Resolution& resolution, double share, double distance) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_.at(resolution) = share;
  double done = 0, work = 0;
  for (const auto& [one, its_share] : shares_) {
    work += expected_work(one);
    done += its_share * expected_work(one);
  }
  oversight_.progress(done / work, distance);
}

}  // namespace fretval
