#include "comparison/report/sections/exact_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string errors_text(const ordered_json& errors) {
  std::string text;
  for (const auto& error : errors)
    text += (text.empty() ? "" : ", ") + (error.is_number() ? number_text(error) : "not finite");
  return text;
}

Table convergence_table(const ordered_json& rows) {
  Table table{{"solution: quantity", "refined", "errors", "order (expected)", "tolerance", "verdict", "source; note"}};
  for (const auto& row : rows) {
    const auto text = [&](const char* key) { return row.at(key).get<std::string>(); };
    const auto &order = row.at("observed_order"), &resolutions = row.at("resolutions");
    table.rows.push_back(
        {text("solution") + ": " + text("quantity"),
         fmt::format("{} to {} {}", resolutions.front().get<int>(), resolutions.back().get<int>(), text("refined")),
         errors_text(row.at("errors")),
         fmt::format("{} ({:.2g})", order.is_number() ? number_text(order, "{:.1f}") : "floor",
                     row.at("expected_order").get<double>()),
         number_text(row.at("tolerance")), bad_if(text("verdict") != "pass", text("verdict")),
         words_cell(text("source") + (text("note").empty() ? "" : "; ") + text("note"))});
  }
  return table;
}

std::string passed_text(const ordered_json& rows) {
  const auto n = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.at("verdict") == "pass"; });
  return fmt::format("{} of {} rows pass.", n, rows.size());
}

}  // namespace

Filling convergence_section(const ordered_json& rows) {
  return {{"template", "exact"}, {"passed", passed_text(rows)}, {"table", filling_of(convergence_table(rows))}};
}

std::string convergence_text(const ordered_json& rows) {
  return text_of(convergence_table(rows)) + passed_text(rows) + "\n";
}

}  // namespace fretval
