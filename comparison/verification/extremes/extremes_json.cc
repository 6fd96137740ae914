#include "comparison/verification/extremes/extremes_json.h"

#include "comparison/support/json.h"
#include "comparison/verification/extremes/extremes_table.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// Without the folder of the tables, which is another one on every machine.
ordered_json entries_of(const Entries& entries) {
  auto json = ordered_json::object();
  for (const auto& [place, value] : entries)
    if (!value.empty()) json[place] = place == "Indenter / Table" ? value.substr(value.rfind('/') + 1) : value;
  return json;
}

ordered_json json_of(const ExtremeRecord& record) {
  const auto* worst = worst_of(record);
  auto errors = ordered_json::object();
  for (const auto& [quantity, e] : record.errors)
    errors[quantity] = {{"mdr", or_null(e.mdr)},
                        {"fe", or_null(e.fe)},
                        {"error", or_null(e.error)},
                        {"bar", or_null(e.bar)},
                        {"largest_share", or_null(e.source)},
                        {"tolerance", e.tolerance}};
  return {{"family", record.row.family},
          {"value", record.row.value},
          {"entries", entries_of(record.row.entries)},
          {"verdict", name_of(verdict_of(record))},
          {"remark", or_null(remark_of(record))},
          {"expected_refusal", or_null(record.row.refusal)},
          {"refusal", or_null(record.refusal)},
          {"second_way", record.row.springs ? "springs" : "finite elements"},
          {"errors", std::move(errors)},
          {"worst", worst ? ordered_json(worst->first) : ordered_json(nullptr)},
          {"seconds", record.seconds},
          {"refinements", record.n_refinements},
          {"size_ratio", record.size_ratio},
          {"aspect_ratio", record.aspect_ratio}};
}

}  // namespace

ordered_json extremes_json(const std::vector<ExtremeRecord>& records) {
  auto scenes = ordered_json::array();
  for (const auto& record : records) scenes.push_back(json_of(record));
  return {{"summary",
           {{"scenes", records.size()},
            {"agree", count(records, ExtremeVerdict::agrees)},
            {"refused", count(records, ExtremeVerdict::refused)},
            {"inconclusive", count(records, ExtremeVerdict::inconclusive)},
            {"fail", count(records, ExtremeVerdict::fails)}}},
          {"scenes", std::move(scenes)}};
}

}  // namespace fretval
