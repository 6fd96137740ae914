#include "comparison/report/forces_section.h"

#include <fmt/format.h>

#include <cmath>

#include "comparison/report/table.h"

namespace fretval {
namespace {

std::string compared(const StoredResult& r, const char* key) {
  const auto& comparison = r.json.at("comparison");
  if (!comparison.contains(key)) return "–";
  return number_text(comparison[key]["difference"], "{:+.1e}") + " ± " +
         number_text(comparison[key].value("error_bar", nlohmann::ordered_json()), "{:.0e}");
}

/// "gross slip at 0.89 of the amplitudes, at 0.84 says MDR"
std::string gross_slip_text(const StoredResult& r) {
  const auto& fe = r.json.at("fe");
  const auto share = fe.contains("gross_slip") ? fe["gross_slip"].value("amplitude", nlohmann::ordered_json())
                                               : nlohmann::ordered_json();
  const double mdr = r.number("mdr", "gross_slip");
  if (share.is_null() && std::isnan(mdr)) return "";
  return fmt::format("gross slip at {} of the amplitudes, at {} says MDR", number_text(share, "{:.2f}"),
                     number_text(mdr, "{:.2f}"));
}

}  // namespace

std::string forces_section(const std::vector<StoredResult>& results) {
  Table table{{"case", "c first slip, MDR", "finite elements", "c shakedown, MDR", "finite elements",
               "largest depth or force", "tangential amplitude", ""}};
  for (const auto& r : results) {
    if (!r.has_forces()) continue;
    const auto radius = [&](const char* section, const char* key) {
      return number_text(r.number(section, key) / r.number("scene", "contact_radius_unworn"), "{:.5f}");
    };
    const bool prescribed = r.json.at("scene").contains("normal_force_mean");
    table.rows.push_back({r.json.at("name").get<std::string>(), radius("mdr", "stick_radius_first_slip"),
                          radius("fe", "stick_radius_first_slip"), radius("mdr", "stick_radius_shakedown"),
                          radius("fe", "stick_radius_shakedown"),
                          compared(r, prescribed ? "indentation_max" : "normal_force_max"),
                          compared(r, "tangential_amplitude"), words_cell(gross_slip_text(r))});
  }
  if (table.rows.empty()) return "";
  return "<h2>Prescribed forces</h2>\n<p>The indenter goes where the forces take it. Radii over the contact radius of "
         "the relaxed body under the largest force; of the depth, where the normal force is prescribed, or else of the "
         "force, and of the tangential amplitude the relative difference with its error bar.</p>\n" +
         html_of(table);
}

}  // namespace fretval
