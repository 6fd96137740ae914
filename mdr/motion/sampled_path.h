#pragma once

#include <cstddef>
#include <vector>

namespace fretval::mdr {

/// Motion of the indenter that is given by its rows and linear between them. The body has rested for ever before: a
/// single pass begins at the first row, without tangential force there; a path that repeats is the departure from its
/// mean over time, where the body rests without tangential force.
struct SampledPath {
  std::vector<double> time;         ///< s, rising; two rows at least
  std::vector<double> indentation;  ///< m
  std::vector<double> tangential;   ///< m
  bool repeats = false;             ///< with the period from the first row to the last, which is the first again

  [[nodiscard]] double duration() const { return time.back() - time.front(); }
  [[nodiscard]] std::size_t n_pieces() const { return time.size() - 1; }
};

/// Throws std::invalid_argument unless the path is as described above, in contact where it rests, and its last row
/// equal to the first if it repeats.
void validate(const SampledPath& path);

/// Where the body rests before, m.
struct RestPosition {
  double indentation, tangential;
};
RestPosition rest_position(const SampledPath& path);

/// Largest of the indentations, which are those of rows, m.
double maximum_indentation(const SampledPath& path);

}  // namespace fretval::mdr
