#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparison/accuracy/proof.h"
#include "comparison/quantities/reading.h"
#include "comparison/simulation/bodies/body_store.h"

namespace fretval {

/// One quantity of a case, in the units of comparison (see Quantities).
struct ComparedQuantity {
  double mdr, fe;
  double tolerance;
  std::optional<double> bar;  ///< of fe, infinite where a coarser computation lacks the quantity; empty: no bar
  std::string source = {};    ///< of the largest share of the bar
  double mdr_error = 0;       ///< of springs that were stepped in time

  [[nodiscard]] double error() const { return fe - mdr; }
  /// |error| over the bar, or over the tolerance where there is none, both with mdr_error and a roundoff of 1e-12;
  /// above 1 the row fails. Infinite if MDR or finite elements are not finite or the bar is not a number.
  [[nodiscard]] double share() const;
  [[nodiscard]] bool has_wide_bar() const { return bar && *bar > tolerance; }
};

using ComparedQuantities = std::map<Quantity, ComparedQuantity>;

/// A case of a suite, and the demands on it.
struct SuiteCase {
  std::string family = {}, name = {};  ///< together unique; family: may be empty
  std::string text = {};               ///< of its case file, which has its tolerance
  std::string refusal = {};            ///< words of the message that has to come; empty: an answer has to come
  bool must_be_conclusive = false;     ///< no bar may be wider than its tolerance
  Proof proof = Proof::tolerance;      ///< that the finite elements give
  bool with_cycle = false;             ///< forces and energies of a cycle are compared as well, with MDR's springs
  /// Applied to the case after it was prepared.
  std::function<void(PreparedCase&)> change = {};
  std::shared_ptr<BodyStore> bodies = {};  ///< store with meshes of its own; null: that of the suite
};

/// The result of a case of a suite.
struct SuiteRow {
  SuiteCase asked;
  std::string refusal = {};  ///< message of the bad input or of the numerics that came instead of an answer
  std::string failure = {};  ///< message of any other exception, or of MDR
  ComparedQuantities compared = {};
  std::optional<Outcome> sliding = {};  ///< see outcome_of_sliding: gross slip leaves nothing to compare
  double seconds = 0;                   ///< see ProvedAnswer
  int n_refinements = 0, n_computations = 0;
};

/// agrees: every error is within its bar, and no bar is wider than its tolerance; inconclusive: errors are within their
/// bars, but a bar is wider than its tolerance, or it is not resolved whether all of the contact slides; refused: with
/// the words that the case expects; fails: see failure_of.
enum class RowVerdict { agrees, inconclusive, refused, fails };
const char* name_of(RowVerdict verdict);

/// Why a row fails; empty: it does not. It fails with a refusal that is not expected, without the one that is or with
/// another one, with any other exception, with gross slip that is not found where it has to be, without anything else
/// compared, with a number that is not finite, with an error above its bar (above its tolerance where no bar was asked
/// for), with an infinite bar although it was to meet the tolerance, and with a bar that is wider than its tolerance
/// where the case has to be conclusive.
std::string failure_of(const SuiteRow& row);

RowVerdict verdict_of(const SuiteRow& row);

/// A suite that was run.
struct SuiteRun {
  std::string name;   ///< as on the command line
  std::string about;  ///< description of its cases in a sentence or two
  std::vector<SuiteRow> rows = {};
  double seconds = 0;

  /// Whether there are rows and none of them fails.
  [[nodiscard]] bool passes() const;
};

/// Runs cases in parallel as `fretval run` would, each held against MDR; the rows come in the order of the cases.
/// Exceptions of a case are kept in its row.
std::vector<SuiteRow> run_cases(const std::vector<SuiteCase>& cases, BodyStore& bodies);

/// All cases of a suite at once.
SuiteRun run_suite(const std::string& name, const std::string& about, const std::vector<SuiteCase>& cases);

/// The case of its case file. Throws InputError.
Case case_of(const SuiteCase& suite_case);

/// "family: name"
std::string title_of(const SuiteCase& suite_case);

/// An object with `suite` and `about` (see SuiteRun), `summary` (pass, cases, agree, refused, inconclusive, fail,
/// errors, above_bar, computations, seconds), `quantities`, an array (quantity, tolerance, errors, above_bar, wide, and
/// median and high, 90 %, of error, bar and effectivity), and `rows`, the shown_rows: family, name, verdict, remark,
/// refusal, expected_refusal, quantities (by name: mdr, fe, error, tolerance, bar, source), worst (the quantity closest
/// to its bar), seconds, refinements, computations, case_file (its text). Null stands for missing values and for
/// numbers that are not finite.
nlohmann::ordered_json suite_json(const SuiteRun& run);

/// JUnit XML of all rows; an inconclusive row passes, and says so by its name.
std::string suite_junit(const SuiteRun& run);

/// Errors and bars of one quantity over all cases with one tolerance.
struct QuantitySummary {
  std::size_t n = 0;
  std::size_t n_above = 0;                 ///< errors that are above their bar, see ComparedQuantity::share
  std::size_t n_wide = 0;                  ///< bars that are wider than the tolerance
  std::vector<double> errors = {};         ///< finite |error|
  std::vector<double> bars = {};           ///< finite error bars
  std::vector<double> effectivities = {};  ///< bar over error, where both are finite and the error is not zero
};

/// Summaries by quantity and tolerance.
using QuantitySummaries = std::map<std::pair<Quantity, double>, QuantitySummary>;
QuantitySummaries quantity_summaries(const std::vector<SuiteRow>& rows);

/// Number of rows with a verdict.
std::size_t count(const std::vector<SuiteRow>& rows, RowVerdict verdict);

/// The quantity with the largest share of its bar; null: nothing was compared.
const ComparedQuantities::value_type* worst_of(const SuiteRow& row);

/// The rows that tables and JSON show: all rows of a suite that is small enough to be read, otherwise the worst ten and
/// every row that fails. Failing rows come first then, the others by the largest share of a bar.
std::vector<const SuiteRow*> shown_rows(const std::vector<SuiteRow>& rows);
std::vector<const SuiteRow*> worst_rows(const std::vector<SuiteRow>& rows);

/// Remark on a row beside its numbers: why it fails, the message that it is refused with, or which bars are wider than
/// their tolerance.
std::string remark_of(const SuiteRow& row);

}  // namespace fretval
