#include "comparison/results/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/quantities/reading.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/results/verdict_text.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

constexpr double roundoff = 1e-9;  // of answers without a bar: other processors add up in other orders

using nlohmann::ordered_json;

double bar_in(const StoredResult& result, const char* key) {
  const auto& comparison = result.json.at("comparison");
  return comparison.contains(key) ? number_in(comparison[key], "error_bar").value_or(0) : 0;
}

std::optional<Change> change_of(const StoredResult& before, const StoredResult& after, Quantity quantity) {
  const char* key = name_of(quantity);
  const auto reading = [&](const StoredResult& from) {
    return stored_reading(from.json.at("fe"), quantity).value_or(Reading{});
  };
  const auto old = reading(before), now = reading(after);
  if (!old.value && !now.value) return std::nullopt;
  Change change{after.name(), quantity, old.value, now.value};
  change.bars = bar_in(before, key) + bar_in(after, key);
  if (old.value != now.value) change.difference = difference_of(quantity, now, old, scales_of(before.json)).value_or(1);
  return change;
}

/// What is prescribed, by the names of a case file.
std::map<std::string, std::string> input_texts(const ordered_json& scene) {
  constexpr int tells_apart = 10;  // digits
  std::map<std::string, std::string> texts;
  for (const auto& input : scene.value("inputs", ordered_json::array()))
    texts[fmt::format("{} / {}", input.at("section").get<std::string>(), input.at("name").get<std::string>())] =
        input_text(input.at("value"), input.at("unit").get<std::string>(), tells_apart);
  return texts;
}

void add_inputs(const StoredResult& before, const StoredResult& after, std::vector<std::string>& inputs) {
  const auto olds = input_texts(before.json.at("scene")), news = input_texts(after.json.at("scene"));
  auto entries = olds;
  entries.insert(news.begin(), news.end());
  const auto text_in = [](const std::map<std::string, std::string>& texts, const std::string& entry) {
    const auto found = texts.find(entry);
    return found == texts.end() ? std::string("none") : found->second;
  };
  for (const auto& [entry, unused] : entries)
    if (text_in(olds, entry) != text_in(news, entry))
      inputs.push_back(
          fmt::format("{}: {}: {} -> {}", after.name(), entry, text_in(olds, entry), text_in(news, entry)));
}

std::string value_text(const Change& change, const std::optional<double>& value) {
  const auto& traits = traits_of(change.quantity);
  if (!value) return "none";
  return *traits.unit ? with_unit(*value, 0, traits.unit) : fmt::format("{:.6g}", *value);
}

std::string change_text(const Change& change) {
  return fmt::format("  {}: {}: {} -> {}, by {:.1e}, bars {}\n", change.name, traits_of(change.quantity).title,
                     value_text(change, change.before), value_text(change, change.after), change.difference,
                     change.bars > 0 ? fmt::format("{:.1e}", change.bars) : "none");
}

std::string list_text(const char* title, const std::vector<std::string>& lines) {
  std::string text = lines.empty() ? "" : std::string(title) + "\n";
  for (const auto& line : lines) text += "  " + line + "\n";
  return text;
}

}  // namespace

bool Change::is_beyond_bars() const {
  return !(std::abs(difference) <= std::max(bars, roundoff));
}

bool Changes::any() const {
  return !verdicts.empty() ||
         std::any_of(values.begin(), values.end(), [](const Change& change) { return change.is_beyond_bars(); });
}

std::string Changes::of_case(const std::string& name) const {
  std::string text;
  if (const auto verdict = verdicts.find(name); verdict != verdicts.end()) text += "  " + verdict->second + "\n";
  for (const auto& change : values)
    if (change.name == name && change.is_beyond_bars()) text += change_text(change);
  return text;
}

Changes changes_between(const std::vector<StoredResult>& before, const std::vector<StoredResult>& after) {
  std::map<std::string, const StoredResult*> olds;
  for (const auto& result : before) olds[result.name()] = &result;
  Changes changes;
  for (const auto& result : after) {
    const auto name = result.name();
    const auto old = olds.find(name);
    if (old == olds.end()) {
      changes.only_after.push_back(name);
      continue;
    }
    add_inputs(*old->second, result, changes.inputs);
    for (const auto quantity : quantities_by_interest)
      if (auto change = change_of(*old->second, result, quantity)) changes.values.push_back(std::move(*change));
    const auto was = stored_outcome(old->second->json), is = stored_outcome(result.json);
    if (passes(was) != passes(is))
      changes.verdicts[name] = fmt::format("{}: {} before, now {}", name, name_of(was), name_of(is));
    olds.erase(old);
  }
  for (const auto& [name, unused] : olds) changes.only_before.push_back(name);
  return changes;
}

std::string changes_text(const Changes& changes) {
  std::string beyond;
  double largest = 0;
  std::size_t n_beyond = 0;
  for (const auto& change : changes.values) {
    if (change.is_beyond_bars()) {
      beyond += change_text(change);
      ++n_beyond;
    } else {
      largest = std::max(largest, std::abs(change.difference));
    }
  }
  std::vector<std::string> verdicts;
  for (const auto& [name, verdict] : changes.verdicts) verdicts.push_back(verdict);
  return list_text("other inputs:", changes.inputs) + list_text("verdicts:", verdicts) +
         list_text("only in the first folder:", changes.only_before) +
         list_text("only in the second folder:", changes.only_after) +
         (n_beyond ? "beyond the error bars of both together:\n" + beyond : "") +
         (n_beyond == 0 && largest == 0
              ? fmt::format("none of {} values has moved\n", changes.values.size())
              : fmt::format("{} of {} values moved beyond their bars; the others by up to {:.1e}\n", n_beyond,
                            changes.values.size(), largest));
}

}  // namespace fretval
