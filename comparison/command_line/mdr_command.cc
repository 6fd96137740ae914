#include <fmt/format.h>

#include <utility>

#include "comparison/case/plausibility.h"
#include "comparison/case_file/case_file.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/quantities/reading.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/reference/mdr_document.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/data_text.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

void print_answer(const ordered_json& json) {
  const auto& mdr = json["mdr"];
  const auto springs = json.value("springs", ordered_json::object());
  // Under prescribed forces MDR's closed forms hold for the worn contact, another one than that of the finite elements:
  // the columns are named accordingly.
  const bool worn = json.contains("limiting_state");
  fmt::print("{}{}\n", json["name"].get<std::string>(),
             worn ? ": under prescribed forces, of the contact that has worn to its end" : "");
  if (!springs.empty())
    fmt::print("{}", answer_line("", worn ? "MDR, worn" : "MDR", worn ? "springs, unworn" : "springs"));
  const auto& ratio = mdr["modulus_ratio"];
  fmt::print("{}", answer_line("modulus ratio", ratio.is_null() ? "none" : fmt::format("{:.6g}", ratio.get<double>())));
  const Scales scales{0, mdr.value("tangential_force_max", 0.0), 0};
  for (const auto quantity : quantities_by_interest) {
    const auto& traits = traits_of(quantity);
    const auto shown = [&](const ordered_json& from) {
      const auto reading = stored_reading(from, quantity);
      if (!reading) return std::string();
      if (reading->value) return mdr_text(from, quantity, scales);
      return reading->why_absent.empty() ? std::string("none") : "none (" + reading->why_absent + ")";
    };
    const auto by_mdr = shown(mdr), by_springs = shown(springs);
    if (!*traits.unit || (by_mdr + by_springs).empty()) continue;
    fmt::print("{}", worn && springs.empty()
                         ? fmt::format("  {:<32} {}\n", traits.title + std::string(", worn"), by_mdr)
                         : answer_line(traits.title, by_mdr, by_springs));
  }
  if (json.contains("wear")) {
    const auto& wear = json["wear"];
    fmt::print("{}", answer_line("worn volume",
                                 fmt::format("{} after {:.6g} cycles", volume_text(wear["volume"].back().get<double>()),
                                             wear["cycles"].back().get<double>())));
  }
  if (!json.contains("elastomer")) return;
  for (const auto& [key, title] :
       {std::pair{"residual", "Prony fit: misfit"}, std::pair{"held_out", "Prony fit: held out"}})
    fmt::print("{}", answer_line(title, fmt::format("{:.2g} %", 100 * json["elastomer"][key].get<double>())));
}

}  // namespace

int run_mdr(const std::string& file, const MdrOptions& options) {
  const auto cases = read_case_file(file, Accuracy::optional);
  if (!options.fields.empty() && cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many fields; --fields needs a file with a single case", file));
  auto list = ordered_json::array();
  for (const auto& input : cases) {
    for (const auto& note : input.notes) log::info_once(note);
    if (const auto text = duration_text(input); !text.empty()) log::info(text);
    for (const auto& warning : input.warnings) log::warn_once(warning);
    const auto document = mdr_document(input, options.springs);
    for (const auto& warning : implausible_values(input, profile_of(input.indenter))) log::warn_once(warning);
    if (options.springs)
      for (const auto& warning : document.json["springs"]["warnings"])
        log::warn(fmt::format("{}: {}", input.name, warning.get<std::string>()));
    if (!options.fields.empty()) write_csv(options.fields, surface_columns(input, document.worn));
    if (options.json) {
      list.push_back(document.json);
    } else {
      print_answer(document.json);
    }
  }
  if (options.json) fmt::print("{}\n", (list.size() == 1 ? list[0] : list).dump(2));
  return exit_agree;
}

}  // namespace fretval
