#pragma once

#include <cstddef>
#include <optional>

#include "mdr/motion/record_reduction.h"

namespace fretval::mdr {

/// The mean of the cycles of a record that repeats itself.
struct MeanCycle {
  Record cycle;                               ///< from time 0 to the period; the last row is the first again
  std::size_t n_cycles;                       ///< number of cycles of the record of which it is the mean
  std::size_t n_before;                       ///< rows of the record ahead of these cycles, left out
  double normal_scatter, tangential_scatter;  ///< standard deviation from cycle to cycle, root mean square over a cycle
  [[nodiscard]] double period() const { return cycle.time.back(); }
};

/// Finds the period in the second half of a record, as the least shift that brings both signals onto themselves better
/// than any shorter one, over as many periods as there are, and then by least squares as the one with which cycles lag
/// behind their mean neither more nor less from one to the next. Whole cycles are counted back from the last row; the
/// first of them are left out for as long as they differ from the others by more than ten times what those differ by,
/// as the approach of an indenter does. In each of up to 240 parts of the cycle the mean of all rows is taken, at their
/// mean phase.
///
/// Empty: no shift brings the record onto itself to 10 % of its variance, or there are less than two whole cycles, or
/// less than 16 rows in one.
std::optional<MeanCycle> mean_cycle(const Record& record);

}  // namespace fretval::mdr
