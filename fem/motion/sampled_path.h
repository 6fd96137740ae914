#pragma once

#include <vector>

#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// What is prescribed to the indenter by its rows and linear between them, in dimensionless time from 0 to 2 pi.
struct SampledPath {
  std::vector<double> time;                ///< rising, from 0 to 2 pi; two rows at least
  std::vector<double> normal, tangential;  ///< of each row, displacements or forces as Motion says
  double rest_normal, rest_tangential;     ///< values at which the body rests before, without tangential force
  bool repeats;                            ///< with a period of 2 pi; false: a single pass
  std::vector<double> transverse = {};     ///< of each row, along y; empty: the indenter moves along x alone
  double rest_transverse = 0;

  [[nodiscard]] bool moves_across() const { return !transverse.empty(); }

  [[nodiscard]] std::size_t n_pieces() const { return time.size() - 1; }
};

/// The value at a time of the cycle, from 0 to 2 pi, on the straight piece that holds the instant `inside`.
ValueAndRate along(const SampledPath& path, const std::vector<double>& values, double t, double inside);

/// Number of steps in a cycle, with a whole number of steps in each piece of the path. wanted: about as many there are
/// on a path of few rows, and more on a path of many rows. From 9 on, twice the number wanted halves each step.
int steps_along(const SampledPath& path, int wanted);

/// Where a step lies in its piece of a path: signals are smooth inside a piece and have kinks, or with a dashpot jumps,
/// at its ends.
struct StepInPiece {
  double begin, end;    ///< times of the step, in the cycle
  bool first, last;     ///< whether it is the first, the last step of its piece
  double fraction = 1;  ///< share of the step at which a signal is sampled
  [[nodiscard]] double duration() const { return end - begin; }
};

/// The steps of a cycle, n_steps of them as counted by steps_along; in rising order.
std::vector<StepInPiece> steps_of(const SampledPath& path, int n_steps);

}  // namespace fretval::fem
