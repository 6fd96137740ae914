#include "comparison/accuracy/computations.h"

#include <algorithm>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/support/parallel.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

Computation attempt(const Compute& compute, const Resolution& resolution) {
  try {
    Computation computation{compute(resolution)};
    if (computation.fe.gross_slip) computation.failure = "the whole contact slides";
    return computation;
  } catch (const fem::SolverError& error) {
    return {{}, error.what()};
  } catch (const meshes::MeshError& error) {
    return {{}, error.what()};
  }
}

}  // namespace

void Computations::compute(const std::vector<Resolution>& resolutions) {
  std::vector<Resolution> missing;
  for (const auto& resolution : resolutions)
    if (all_.count(resolution) == 0 && std::find(missing.begin(), missing.end(), resolution) == missing.end())
      missing.push_back(resolution);
  std::vector<Computation> computed(missing.size());
  for_each_in_parallel(
      missing.size(), [&](std::size_t i) { computed[i] = attempt(compute_, missing[i]); }, n_threads_);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    quantities_[missing[i]] = computed[i].failure.empty() ? quantities_of(computed[i].fe, units_) : Quantities{};
    all_[missing[i]] = std::move(computed[i]);
  }
}

}  // namespace fretval
