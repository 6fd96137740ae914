#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/quantities/quantity.h"
#include "comparison/reference/normal_responses.h"
#include "comparison/run/batch.h"

namespace fretval {

/// Unit of a swept entry: "deg", or empty. entry: as in Case::Sweep.
std::string unit_of_entry(const std::string& entry);

/// Symbol of an entry, "φ_0", with subscripts as plots have them; empty: it has none.
std::string symbol_of_entry(const std::string& entry);

/// Head of the column of an entry in a CSV file: "Motion / Phase [deg]".
std::string column_of_entry(const std::string& entry);

/// MDR's answer between the points of each sweep among some cases, in two files in the folder of the family. `mdr.csv`:
/// what has a closed form (both stick radii, contact radius, outer radius of the wear), at a hundred values.
/// `mdr_springs.csv`: also the quantities for which springs are stepped in time, some 20 ms of a core for a value: at a
/// hundred values, or fewer if there are many sweeps, but at least 24. All quantities stand in this file alone, at 24
/// values, for a case under prescribed forces, over a layer, of a motion in two directions, with several normal
/// harmonics, or with measured moduli, which are fitted for each value. Under forces and in two directions by half as
/// many springs and steps as at the points, which is enough for a line (energies of friction to 3e-4).
/// Columns: the entry, then the quantities, "nan" where MDR has none. Nothing is written where the entry does not take
/// values between, nor where values are so costly and the motion has no period.
class SweepLines {
 public:
  explicit SweepLines(const std::vector<Case>& cases);
  ~SweepLines();
  SweepLines(const SweepLines&) = delete;
  SweepLines& operator=(const SweepLines&) = delete;

  /// The work for all lines, except that at the values of the cases themselves. It must not outlive this.
  BesideCases work();

  /// Says which sweeps have no line, or a costly one.
  void log_costs() const;

  /// Writes the files, when all of the work is done. computed: the lines of the cases, whose answers have the values by
  /// springs; values that are missing are computed now.
  void write(const std::filesystem::path& output, const std::vector<BatchLine>& computed);

 private:
  struct Line;
  struct Task;
  std::vector<std::string> without_line_, costly_;  // families
  std::set<std::filesystem::path> folders_;         // of all families, also of maps, in the output
  std::vector<Line> lines_;
  std::vector<Task> tasks_;
  NormalResponses normal_responses_;
};

/// A quantity over the swept entry, read from the files of a sweep; empty if it is not there. family: folder of the
/// sweep.
std::pair<std::vector<double>, std::vector<double>> read_sweep_line(const std::filesystem::path& family,
                                                                    const std::string& entry, Quantity quantity);

}  // namespace fretval
