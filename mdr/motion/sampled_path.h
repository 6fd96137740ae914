#pragma once

#include <cstddef>
#include <vector>

namespace fretval::mdr {

/// What is prescribed to the indenter by its rows and linear between them, a displacement or a force in each direction.
/// The body has rested for ever before: a single pass begins at the first row, without tangential force there; a path
/// that repeats is the departure from rest, at the mean over time of what is prescribed normally and tangentially of
/// the displacement, without tangential force.
struct SampledPath {
  std::vector<double> time;        ///< s, rising; two rows at least
  std::vector<double> normal;      ///< indentation in m, or force in N
  std::vector<double> tangential;  ///< displacement in m, or force in N
  bool repeats = false;            ///< with the period from the first row to the last, which is the first again
  bool normal_force = false, tangential_force = false;  ///< what the columns are; false: displacements

  std::vector<double> transverse = {};  ///< u_y in m, F_y in N where x is F_x; empty: it moves along x alone

  [[nodiscard]] double duration() const { return time.back() - time.front(); }
  [[nodiscard]] std::size_t n_pieces() const { return time.size() - 1; }
  [[nodiscard]] bool has_forces() const { return normal_force || tangential_force; }
};

/// Throws std::invalid_argument unless the path is as described above, in contact where it rests, a normal force
/// positive in every row, and its last row equal to the first if it repeats.
void validate(const SampledPath& path);

/// Displacements in m at which the indenter rests before the path begins, or forces in N under which it does; the
/// tangential force is 0 then.
struct PathRest {
  double normal, tangential, transverse = 0;
};
PathRest rest_of(const SampledPath& path);

/// Largest indentation in m or normal force in N of the path, which is that of a row.
double maximum_normal(const SampledPath& path);

}  // namespace fretval::mdr
