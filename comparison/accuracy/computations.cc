#include "comparison/accuracy/computations.h"

#include <algorithm>
#include <mutex>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/support/parallel.h"
#include "fem/contact/gross_slip.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

Computation attempt(const Compute& compute, const Resolution& resolution) {
  auto computation = attempted([&] { return compute(resolution); });
  if (computation.fe.as<GrossSlipStart>()) computation.failure = "the whole contact slides";
  return computation;
}

}  // namespace

std::string failure_in(const std::function<void()>& compute) {
  try {
    compute();
    return {};
  } catch (const fem::SolverError& error) {
    return error.what();
  } catch (const meshes::MeshError& error) {
    return error.what();
  } catch (const fem::GrossSlip&) {  // which an answer without wear tells
    return "the whole contact slides before anything has worn: the tangential force reaches mu times the normal force";
  }
}

ProofCost operator+(const ProofCost& a, const ProofCost& b) {
  return {a.computations + b.computations,
          a.time_steps + b.time_steps,
          a.cycles + b.cycles,
          a.seconds + b.seconds,
          {a.bodies.all + b.bodies.all, a.bodies.from_store + b.bodies.from_store}};
}

ProofCost Computations::cost() const {
  ProofCost cost;
  std::vector<std::shared_ptr<const BodySummary>> bodies;
  for (const auto& [resolution, computation] : all_) {
    ++cost.computations;
    cost.time_steps += computation.fe.n_steps;
    cost.cycles += computation.fe.n_cycles;
    cost.seconds += computation.seconds;
    bodies.push_back(computation.fe.body);
  }
  cost.bodies = count_of(bodies);
  return cost;
}

void Computations::compute(const std::vector<Resolution>& resolutions) {
  std::vector<Resolution> missing;
  for (const auto& resolution : resolutions)
    if (all_.count(resolution) == 0 && std::find(missing.begin(), missing.end(), resolution) == missing.end())
      missing.push_back(resolution);
  std::vector<Computation> computed(missing.size());
  std::mutex mutex;
  int n_done = size();
  const int n_known = n_done + static_cast<int>(missing.size());
  for_each_in_parallel(
      missing.size(),
      [&](std::size_t i) {
        computed[i] = attempt(compute_, missing[i]);
        if (!told_) return;
        const std::lock_guard<std::mutex> lock(mutex);
        told_(++n_done, n_known);
      },
      n_threads_);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    quantities_[missing[i]] = computed[i].failure.empty() ? quantities_of(computed[i].fe, units_) : Quantities{};
    all_[missing[i]] = std::move(computed[i]);
  }
}

}  // namespace fretval
