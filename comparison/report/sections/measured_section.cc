#include <fmt/format.h>

#include <cmath>

#include "comparison/quantities/quantity.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// Relative, or as it is to nothing measured. σ: the uncertainty of what was measured.
std::string difference_text(const ordered_json& one, const char* method, const char* unit) {
  const auto& difference = one.at(std::string(method) + "_difference");
  if (difference.is_null()) return "–";
  const double value = one.at("value").get<double>(), off = difference.get<double>();
  const double uncertainty = one.at("uncertainty").get<double>();
  const auto [prefix, factor] = prefix_for(std::abs(off));
  auto text = value != 0 ? fmt::format("{:+.2g} %", 100 * off / value)
                         : fmt::format("{:+.3g} {}{}", off / factor, prefix, unit);
  if (uncertainty > 0) text += fmt::format(", {:.2g} σ", std::abs(off) / uncertainty);
  return text;
}

std::string quantity_text(const ordered_json& value, double uncertainty, const char* unit) {
  return value.is_null() ? "none" : with_unit(value.get<double>(), uncertainty, unit);
}

}  // namespace

Filling measured_table(const StoredResult& r) {
  const auto measured = r.json.find("measured");
  if (measured == r.json.end() || measured->empty()) return nullptr;
  Table table{{"quantity", "measured", "finite elements", "off by", "MDR", "off by"}};
  table.label = "what was measured beside both methods";
  for (const auto quantity : quantities_by_interest) {
    const auto one = measured->find(name_of(quantity));
    if (one == measured->end()) continue;
    const char* unit = traits_of(quantity).unit;
    table.rows.push_back({traits_of(quantity).title,
                          quantity_text(one->at("value"), one->at("uncertainty").get<double>(), unit),
                          quantity_text(one->at("fe"), 0, unit), difference_text(*one, "fe", unit),
                          quantity_text(one->at("mdr"), 0, unit), difference_text(*one, "mdr", unit)});
  }
  return filling_of(table);
}

Filling data_sentences(const StoredResult& r) {
  const auto& scene = r.json.at("scene");
  if (!scene.contains("data")) return nullptr;
  const auto& data = scene["data"];
  auto sentences = Filling::array();
  const auto add = [&](const std::string& text) { sentences.push_back(text); };
  if (data.contains("test_duration")) {
    const auto& test = data["test_duration"];
    add(fmt::format(
        "The test lasts {:g} s: {} of {} branches of the elastomer are slower and count as springs; {} others "
        "are merged, which changes the complex modulus by {:.1e} at most.",
        test.at("duration").get<double>(), test.at("slow_branches").get<int>(), test.at("branches_of_data").get<int>(),
        test.at("merged_branches").get<int>(), test.at("merging_error").get<double>()));
  }
  if (data.contains("record")) {
    const auto& record = data["record"];
    const auto& columns = scene.at("path").at("columns");
    const auto by = [&](const char* normal, const char* tangential) {
      const auto one = [&](const char* key, std::size_t column) {
        const bool is_force = columns.at(column).get<std::string>()[0] == 'F';
        return fmt::format("{:.2g} {}", record.value(key, 0.0), is_force ? "N" : "m");
      };
      return fmt::format("{} normally and {} tangentially", one(normal, 1), one(tangential, 2));
    };
    auto text = fmt::format("The record has {} rows, {} of them before contact", record.at("rows").get<long>(),
                            record.at("rows_before_contact").get<long>());
    if (const long n_cycles = record.at("cycles").get<long>(); n_cycles > 0)
      text += fmt::format("; it is folded to the mean of {} cycles, which scatter by {}", n_cycles,
                          by("normal_scatter", "tangential_scatter"));
    text += fmt::format("; {} rows stand for it", record.at("rows_kept").get<long>());
    if (record.value("normal_error", 0.0) > 0 || record.value("tangential_error", 0.0) > 0)
      text += " within " + by("normal_error", "tangential_error");
    add(text + ". What that leaves open is in the error bars, as what the data do.");
  }
  if (data.contains("trace"))
    add(fmt::format(
        "The indenter comes from a raw trace: apex {} ± {} off, tilted by {:.3g} ± {:.1g}°. What that leaves "
        "open is in the error bars, as what the data do.",
        with_prefix(std::abs(data["trace"].at("apex").get<double>()), "m"),
        with_prefix(data["trace"].at("apex_uncertainty").get<double>(), "m"), data["trace"].at("tilt").get<double>(),
        data["trace"].at("tilt_uncertainty").get<double>()));
  if (data.contains("hardness"))
    add(fmt::format(
        "The modulus comes from a hardness of {:g} Shore A by Gent's formula, from which rubbers scatter by "
        "{:.0f} %: forces under prescribed displacements are as uncertain.",
        data["hardness"].at("shore_a").get<double>(), 100 * data["hardness"].at("scatter").get<double>()));
  return sentences;
}

}  // namespace fretval
