#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparison/simulation/resolution.h"
#include "comparison/verification/random_cases/random_cases.h"

namespace fretval {

/// The quantities of a case, see Measures; the last three are those of a limiting profile.
constexpr std::array<const char*, 7> soak_quantities{
    "stick_radius_first_slip", "stick_radius_shakedown",   "contact_radius_max", "normal_force_max",
    "slip_inside_stick_zone",  "force_outside_stick_zone", "maximum_indentation"};

/// One quantity of a case in the units of comparison: radii over the unworn contact radius at the largest indentation
/// (0: nothing sticks), logarithms of forces over G'(0) d_max a.
struct SoakError {
  double mdr, fe;
  double bar;          ///< of the finite elements; infinite where a coarser computation does not have the quantity
  ErrorSource source;  ///< of the largest share of the bar

  [[nodiscard]] double error() const { return fe - mdr; }
  [[nodiscard]] bool is_finite() const;
  /// |error| over the bar; both get a roundoff of 1e-12.
  [[nodiscard]] double share() const;
  [[nodiscard]] bool covered() const;
};

/// What became of a case. A fixed size but for the words, so that ten thousand of them do not look like a leak.
struct SoakRecord {
  SoakDraw draw{};
  std::array<std::optional<SoakError>, soak_quantities.size()> errors;
  std::string failure;  ///< of the numerics, of MDR, or any other exception; empty: none
  std::string refusal;  ///< why the draw before this one was refused as bad input; empty: it was the first
  double seconds = 0;   ///< of the histories at the chosen resolution

  /// The quantity with the largest share of its bar; empty: nothing was compared.
  [[nodiscard]] std::optional<std::size_t> worst() const;
};

/// Why a case fails; empty: it does not. It fails with a failure, without anything to compare, with a number that is
/// not finite or a bar that is not one, or with an error above its bar.
std::string failure_of(const SoakRecord& record);

/// Resident memory after a number of cases.
struct MemorySample {
  std::size_t n_cases;
  double bytes;
};

struct SoakRun {
  std::uint64_t seed = 0;
  std::vector<SoakRecord> records;
  std::vector<MemorySample> memory;  ///< after each batch; empty where the system does not tell
  long n_histories = 0;              ///< of friction, at this resolution and at those that measure its error bars
  double seconds = 0;
};

struct SoakOptions {
  std::size_t n_cases = 10000;
  std::uint64_t seed = 1;
  std::optional<std::size_t> only;  ///< the number of the one case that is to be run, from 0
  std::size_t batch = 100;          ///< cases that are computed together
};

/// Runs random cases on one coarse discretisation whose bodies are made once, each with its error bars
/// (StudyDepth::budget) but without any refinement, and holds them against MDR. A case that the tool refuses as bad
/// input (InputError) is drawn again, at most 100 times; nothing else is left out. after_batch: called with the number
/// of cases that are done.
SoakRun run_soak(
    const SoakOptions& options, const std::function<void(std::size_t n_done)>& after_batch = [](auto) {});

}  // namespace fretval
