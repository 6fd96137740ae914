#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/support/files.h"
#include "mdr/springs/spring_history.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval {

/// The analytic answer to a case and what else its user asked for, as `fretval mdr --json` prints it; docs/results.md
/// describes the entries.
struct MdrDocument {  // NOLINT(bugprone-exception-escape): moving JSON checks an invariant, and throws nothing
  nlohmann::ordered_json json;
  std::optional<mdr::LimitingProfile> worn;  ///< profile in which nothing wears any more; empty: there is none
};

/// with_springs: also the transient spring foundation. Throws InputError for what cannot be answered, naming the case
/// file.
MdrDocument mdr_document(const Case& input, bool with_springs);

/// The body that stands for measured moduli, and how well it fits them.
nlohmann::ordered_json fit_json(const Case::Elastomer& elastomer);

/// How finely the springs are stepped, see mdr::HistoryControl.
struct SpringSetting {
  Eigen::Index n_springs = 400;
  int steps_per_cycle = 360;  ///< of the fastest harmonic
  int n_ramp_periods = 20;
  double periodicity = 1e-7;
  int n_oscillations = 96;  ///< in a cycle that stands for a motion without period, see mdr::repeating_motion
};

/// History of the transient spring foundation of a case over a half-space; the indenter is unworn, also where forces
/// are prescribed. States of the springs (SpringHistory::deepest, highest, last) and their mean traction are those of
/// the incompressible springs that stand for those of the case, with MdrCase::body and MdrCase::displacement.
struct SpringAnswer {
  mdr::SpringBed bed;
  mdr::SpringHistory history;
  int steps_per_period;
};
/// Why a case has no such history: another body than a half-space, a worn indenter, a motion in two directions. Empty:
/// it has one.
std::string why_no_springs(const Case& input);

/// Throws InputError where there is none (why_no_springs).
SpringAnswer spring_answer(const Case& input, const SpringSetting& setting = {});

/// Fields on the surface of a half-space over r, at the largest and smallest indentation of the periodic state, and in
/// the limiting state at the largest one.
std::vector<Column> surface_columns(const Case& input, const std::optional<mdr::LimitingProfile>& worn);

}  // namespace fretval
