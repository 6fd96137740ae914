#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "comparison/quantities/reading.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/stopwatch.h"

namespace fretval {

/// What was computed, or the failure of the numerics that kept it from coming.
template <class Fe>
struct Computed {
  Fe fe = {};
  std::string failure = {};
  double seconds = 0;  ///< of the processor
};

/// Why the numerics fail in a function; empty: they do not. Other exceptions are thrown.
std::string failure_in(const std::function<void()>& compute);

/// What a function computes, or why its numerics fail.
template <class Function>
auto attempted(const Function& compute) {
  Computed<decltype(compute())> computed;
  const double start = processor_seconds();
  computed.failure = failure_in([&] { computed.fe = compute(); });
  computed.seconds = processor_seconds() - start;
  return computed;
}

/// The answer to a case at one resolution. Gross slip counts as a failure, too, as nothing is to be refined then, but
/// its answer is there and says when it starts.
using Computation = Computed<FeAnswer>;

/// What all computations of a proof took together.
struct ProofCost {
  int computations = 0;
  long time_steps = 0, cycles = 0;
  double seconds = 0;  ///< of the processor, for the bodies that were made for these computations as well
  BodyCount bodies = {};
};
ProofCost operator+(const ProofCost& a, const ProofCost& b);

/// How far computations have come: those that are done and those that are known to be needed.
using ComputationsDone = std::function<void(int n_done, int n_known)>;

/// Computes a case at a resolution, as compute_case does.
using Compute = std::function<FeAnswer(const Resolution&)>;

/// A case at all the resolutions that its proof asks for, each computed once.
class Computations {
 public:
  /// n_threads: number of computations at once. told: called after each computation, one call at a time.
  Computations(const Units& units, Compute compute, std::size_t n_threads, ComputationsDone told = {})
      : units_(units), compute_(std::move(compute)), n_threads_(n_threads), told_(std::move(told)) {}

  /// Computes the resolutions that are not there yet. A failure of the numerics is kept as the failure of a
  /// Computation; other exceptions are thrown.
  void compute(const std::vector<Resolution>& resolutions);

  [[nodiscard]] const Computation& at(const Resolution& resolution) const { return all_.at(resolution); }
  [[nodiscard]] bool failed(const Resolution& resolution) const { return !at(resolution).failure.empty(); }
  /// The quantities that are compared, by resolution; empty where the numerics failed.
  [[nodiscard]] const std::map<Resolution, Quantities>& quantities() const { return quantities_; }
  [[nodiscard]] const Units& units() const { return units_; }
  [[nodiscard]] int size() const { return static_cast<int>(all_.size()); }
  [[nodiscard]] ProofCost cost() const;  ///< of all computations

 private:
  Units units_;
  Compute compute_;
  std::size_t n_threads_;
  ComputationsDone told_;
  std::map<Resolution, Computation> all_;
  std::map<Resolution, Quantities> quantities_;
};

}  // namespace fretval
