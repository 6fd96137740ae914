#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparison/verification/extremes/extreme_rows.h"

namespace fretval {

/// One quantity of a scene, in the units of comparison: radii over the unworn contact radius at the largest indentation
/// (0: nothing sticks), forces over G'(0) d_max a.
struct ExtremeError {
  double mdr, fe;           ///< fe: finite elements, or the springs that take their place
  double error;             ///< fe less mdr; of forces, of their logarithms
  double tolerance, bar;    ///< bar: of fe
  std::string source = {};  ///< of the largest share of the bar

  [[nodiscard]] bool is_finite() const;
  [[nodiscard]] bool covered() const;
};

/// What became of a scene.
struct ExtremeRecord {
  ExtremeRow row;
  std::string refusal;      ///< message of the InputError, SolverError or MeshError that came instead of an answer
  std::string malfunction;  ///< message of any other exception, or of MDR
  std::map<std::string, ExtremeError> errors;
  double seconds = 0;  ///< of the chosen resolution, as if the scene ran alone and without a budget
  int n_refinements = 0;
  double size_ratio = 0;  ///< largest edge of the mesh over its smallest one, or over the ring that a focus asks for
  double aspect_ratio = 0;
};

/// agrees: every quantity is within its tolerance and its error within a bar that is not wider than the tolerance.
/// inconclusive: within a bar that is wider than the tolerance. refused: with the message that the row expects.
enum class ExtremeVerdict { agrees, inconclusive, refused, fails };
const char* name_of(ExtremeVerdict verdict);

/// Why a scene fails; empty: it does not. It fails with a refusal that the row does not expect, without the one that it
/// expects or with another message, with anything else than an answer or a refusal, without any quantity to compare,
/// with a number or a bar that is not finite, with an error above its bar, or with one above its tolerance although the
/// bar is not wider than that.
std::string failure_of(const ExtremeRecord& record);

ExtremeVerdict verdict_of(const ExtremeRecord& record);

/// How many scenes came to a verdict.
std::size_t count(const std::vector<ExtremeRecord>& records, ExtremeVerdict verdict);

/// Runs the scenes as `fretval run` would, all together, each with an error budget.
std::vector<ExtremeRecord> run_extremes(const std::vector<ExtremeRow>& rows);

}  // namespace fretval
