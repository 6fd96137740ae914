#pragma once

#include <string>
#include <vector>

#include "comparison/results/batch.h"

namespace fretval {

/// Progress on stderr: a bar that redraws itself on a terminal, a line per tenth elsewhere.
class Progress {
 public:
  Progress();
  void show(const BatchLine& line, std::size_t n_done, std::size_t n_cases);

 private:
  bool on_terminal_;
  std::size_t last_tenth_ = 0;
  int n_disagree_ = 0, n_failed_ = 0;
};

/// The answer to a single case, see answer_text.
void print_answer(const BatchLine& line);

/// A line per case file on stdout: how many of its cases agree, and which comes closest to its tolerance; every failed
/// case.
void print_verdicts(const std::vector<BatchLine>& lines);

}  // namespace fretval
