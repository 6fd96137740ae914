#include <cmath>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

/// Adds a value without an error bar, by both methods, if finite elements have it.
void add_row(Table& table, const char* title, double fe, double mdr, const char* unit) {
  if (!(fe > 0)) return;
  const auto shown = [&](double value) { return value > 0 ? with_prefix(value, unit, 4) : "–"; };
  table.rows.push_back({title, shown(fe), shown(mdr), "", ""});
}

/// The values of finite elements alone.
Table table_beyond_mdr(const Answer& answer) {
  Table table{{"quantity", "finite elements"}};
  table.label = "the answer";
  for (const auto& row : answer.rows) table.rows.push_back({row.title, row.fe});
  return table;
}

Table answer_table(const StoredResult& r, const Answer& answer) {
  if (r.is_beyond_mdr()) return table_beyond_mdr(answer);
  Table table{{"quantity", "finite elements", "MDR", "difference", ""}};
  table.label = "the answer";
  bool asked = true;
  for (const auto& row : answer.rows) {
    if (asked && !row.asked) table.rows.push_back({head_cell("not asked for, as far as they are known")});
    asked = row.asked;
    table.rows.push_back(
        {row.title, row.fe, row.mdr, row.difference, bad_if(row.remark == name_of(Verdict::disagree), row.remark)});
  }
  // The energy of a cycle that only stands for the motion says nothing about the motion.
  if ((r.has_period() || is_pass(r.motion_kind())) &&
      !r.json.at("comparison").contains(name_of(Quantity::friction_work)))
    add_row(table, is_pass(r.motion_kind()) ? "energy lost to friction" : "energy lost to friction per period",
            r.number("fe", "friction_work"), std::nan(""), "J");
  if (std::isnan(r.number("fe", "worn_radius")) && r.number("mdr", "worn_radius") > 0)
    table.rows.push_back({"wear ends at the radius a∞", "", with_unit(r.number("mdr", "worn_radius"), 0, "m"), "", ""});
  return table;
}

Filling one_case(const StoredResult& r) {
  const auto cycle = read_cycle(r);
  const auto answer = answer_of(r.json);
  Filling filling{{"name", r.family()},
                  {"about", r.text("scene", "shape") + ", " + r.text("scene", "rheology")},
                  {"answer", answer.plain.empty() ? answer.verdict : answer.plain},
                  {"table", answer.rows.empty() ? Filling() : filling_of(answer_table(r, answer))},
                  {"scene", scene_of(r)},
                  {"figures", case_figures(r, cycle)},
                  {"assumptions", assumptions_of(r)}};
  if (auto measured = measured_table(r); !measured.is_null()) filling["measured"] = {{"table", std::move(measured)}};
  if (auto data = data_sentences(r); !data.is_null()) filling["data"] = std::move(data);
  if (!answer.half_space.empty()) filling["half_space"] = answer.half_space;
  if (!answer.rings.empty()) filling["rings"] = answer.rings;
  if (!answer.sensitivity.empty()) filling["sensitivity"] = answer.sensitivity;
  if (is_pass(r.motion_kind())) filling["why_no_shakedown"] = no_shakedown_in_a_pass;
  return filling;
}

}  // namespace

Filling cases_section(const std::vector<StoredResult>& results) {
  auto cases = Filling::array();
  for (const auto& r : results)
    if (r.sweep().empty()) cases.push_back(one_case(r));
  if (cases.empty()) return nullptr;
  return {{"template", "cases"}, {"cases", std::move(cases)}};
}

}  // namespace fretval
