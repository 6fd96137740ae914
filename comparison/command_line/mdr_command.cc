#include "comparison/command_line/mdr_command.h"

#include <fmt/format.h>

#include <vector>

#include "comparison/case/case_file.h"
#include "comparison/case/plausibility.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/reference/mdr_document.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string value_text(const ordered_json& value, const char* unit, const char* none) {
  if (value.is_null()) return none;
  return fmt::format("{:.6g}{}{}", value.get<double>(), *unit ? " " : "", unit);
}

void print_answer(const ordered_json& json, bool single_pass) {
  struct Line {
    const char *key, *label, *unit, *none;
  };
  fmt::print("{}\n", json["name"].get<std::string>());
  const auto print = [](const ordered_json& from, const std::vector<Line>& lines) {
    for (const auto& [key, label, unit, none] : lines)
      if (from.contains(key)) fmt::print("  {:<30}{}\n", label, value_text(from[key], unit, none));
  };
  print(json["mdr"], {{"modulus_ratio", "modulus ratio", "", "none"},
                      {"contact_radius_max", "largest contact radius", "m", "none"},
                      {"stick_radius_first_slip", "stick radius, first slip", "m", "none (nothing sticks)"},
                      {"stick_radius_shakedown", "stick radius, shakedown", "m",
                       single_pass ? "none (a single pass has no periodic state)" : "none (nothing sticks)"},
                      {"worn_radius", "outer radius of the wear", "m", single_pass ? "none" : "none (wear goes on)"},
                      {"normal_force_max", "largest normal force", "N", "not computed; see --springs"},
                      {"axis_pressure_max", "largest pressure on the axis", "Pa", ""}});
  if (json.contains("springs"))
    print(json["springs"], {{"stick_radius_first_slip", "springs: first slip", "m", "none (nothing sticks)"},
                            {"stick_radius_shakedown", "springs: shakedown", "m", "none (nothing sticks)"},
                            {"normal_force_max", "springs: largest force", "N", ""},
                            {"friction_work", "springs: friction per cycle", "J", ""},
                            {"bulk_work", "springs: bulk per cycle", "J", ""}});
  if (json.contains("wear")) {
    const auto& wear = json["wear"];
    fmt::print("  {:<30}{:.6g} m^3 after {:.6g} cycles\n", "worn volume", wear["volume"].back().get<double>(),
               wear["cycles"].back().get<double>());
  }
  if (json.contains("elastomer"))
    print(json["elastomer"], {{"residual", "Prony fit: misfit", "", ""}, {"held_out", "Prony fit: held out", "", ""}});
}

}  // namespace

int run_mdr(const std::string& file, const MdrOptions& options) {
  const auto cases = read_case_file(file, Accuracy::optional);
  if (!options.fields.empty() && cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many fields; --fields needs a file with a single case", file));
  auto list = ordered_json::array();
  for (const auto& input : cases) {
    for (const auto& warning : input.warnings) log::warn(warning);
    const auto document = mdr_document(input, options.springs);
    for (const auto& warning : implausible_values(input, profile_of(input.indenter))) log::warn(warning);
    if (options.springs)
      for (const auto& warning : document.json["springs"]["warnings"])
        log::warn(fmt::format("{}: {}", input.name, warning.get<std::string>()));
    if (!options.fields.empty()) write_csv(options.fields, surface_columns(input, document.worn));
    if (options.json) {
      list.push_back(document.json);
    } else {
      print_answer(document.json, input.motion.path && !input.motion.path->repeats);
    }
  }
  if (options.json) fmt::print("{}\n", (list.size() == 1 ? list[0] : list).dump(2));
  return exit_agree;
}

}  // namespace fretval
