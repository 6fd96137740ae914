#include "comparison/results/data_text.h"

#include <fmt/format.h>

#include <utility>

#include "comparison/accuracy/data_shares.h"
#include "comparison/case/test_duration.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

constexpr double longer = 3;

std::string data_row(const std::string& title, const std::string& text) {
  return fmt::format("  {:<13}{}\n", title, text);
}

Readings mdr_readings(const Case& input) {
  const auto mdr = mdr_case(input);
  return readings_of(mdr_answer(mdr, mdr_normal_response(mdr)));
}

/// "stick radius, shakedown, by +1.2 %, largest normal force by -3 %"
std::string changes_text(const Readings& before, const Readings& after) {
  std::string text;
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                              Quantity::contact_radius_max, Quantity::normal_force_max, Quantity::indentation_max}) {
    const auto one = before.find(quantity), other = after.find(quantity);
    if (one == before.end() || other == after.end() || !one->second.value || !other->second.value) continue;
    text += fmt::format("{}{} by {:+.2g} %", text.empty() ? "" : ", ", traits_of(quantity).title,
                        100 * (*other->second.value / *one->second.value - 1));
  }
  return text.empty() ? "no zone that both have" : text;
}

/// Changes of MDR's answer if the test were longer, and shorter.
std::pair<std::string, std::string> effects_of_duration(const Case& input) {
  const auto before = mdr_readings(input);
  return {changes_text(before, mdr_readings(with_duration_times(longer, input))),
          changes_text(before, mdr_readings(with_duration_times(1 / longer, input)))};
}

std::string test_text(const Case& input) {
  const auto& test = *input.elastomer.test_duration;
  std::string text =
      fmt::format("{}: {} of {} branches are slower and count as springs, G = {} instead of G'(0) = {}",
                  with_prefix(test.seconds, "s"), test.n_slow, test.branch_times.size(),
                  with_prefix(input.elastomer.relaxed_modulus, "Pa"), with_prefix(test.relaxed_modulus, "Pa"));
  if (test.n_fast > 0)
    text += fmt::format("; {} others are merged, which changes the complex modulus by {:.1e} at most", test.n_fast,
                        test.merging_error);
  return text;
}

std::string near_text(const Case::TestDuration& test) {
  if (test.near_times.empty()) return "no branch relaxes in a third to three times of it";
  std::string times;
  for (const double time : test.near_times) times += (times.empty() ? "" : ", ") + with_prefix(time, "s");
  return fmt::format("near it: {} of relaxation", times);
}

}  // namespace

std::string duration_text(const Case& input) {
  if (!input.elastomer.test_duration) return "";
  try {
    const auto [if_longer, if_shorter] = effects_of_duration(input);
    return fmt::format(
        "{}: test of {}; {}; by MDR a test three times longer would change {}; one three times shorter {}", input.name,
        test_text(input), near_text(*input.elastomer.test_duration), if_longer, if_shorter);
  } catch (const std::exception&) {
    return fmt::format("{}: test of {}; {}", input.name, test_text(input), near_text(*input.elastomer.test_duration));
  }
}

std::string data_text(const Case& input) {
  std::string text;
  for (const auto& note : input.notes) text += data_row("data", note);
  if (const auto& test = input.elastomer.test_duration) {
    text += data_row("test", test_text(input)) + data_row("", near_text(*test));
    try {
      const auto [if_longer, if_shorter] = effects_of_duration(input);
      text += data_row("", "three times longer: " + if_longer) + data_row("", "three times shorter: " + if_shorter);
    } catch (const std::exception& error) {
      text += data_row("", std::string("MDR has no answer to compare longer and shorter tests by: ") + error.what());
    }
  }
  try {
    std::string open;
    for (const auto& [quantity, size] : data_uncertainties(input, mdr_case(input)))
      if (size > 0 && traits_of(quantity).refined_for == RefinedFor::any_case)
        open += fmt::format("{}{} by {:.1e}", open.empty() ? "" : ", ", traits_of(quantity).title, size);
    if (!open.empty()) text += data_row("they leave", "open " + open + ", over the scale of each");
  } catch (const std::exception&) {
    return text;
  }
  return text;
}

}  // namespace fretval
