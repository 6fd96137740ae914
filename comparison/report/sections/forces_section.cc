#include <fmt/format.h>

#include <cmath>

#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"

namespace fretval {
namespace {

/// "gross slip at 0.89 of the amplitudes, at 0.84 says MDR"; of a single pass "gross slip at t = 0.7 s, ..."
std::string gross_slip_text(const StoredResult& r) {
  const auto slip = r.json.at("fe").value("gross_slip", nlohmann::ordered_json::object());
  const auto time = number_text(r.number("mdr", "gross_slip_time"), "{:.4g}");
  const auto share = slip.value("amplitude", nlohmann::ordered_json());
  const double mdr = r.number("mdr", "gross_slip");
  if (share.is_null() && std::isnan(mdr)) return "";
  if (is_pass(r.motion_kind()))
    return fmt::format("gross slip at t = {} s, at {} s says MDR",
                       number_text(slip.value("time", nlohmann::ordered_json()), "{:.4g}"), time);
  return fmt::format("gross slip at {} of the amplitudes, at {} says MDR", number_text(share, "{:.2f}"),
                     number_text(mdr, "{:.2f}"));
}

}  // namespace

Filling forces_section(const std::vector<StoredResult>& results) {
  Table table{{"case", "a", "c first slip, MDR", "finite elements", "c shakedown, MDR", "finite elements",
               "largest depth or force", "tangential amplitude", ""}};
  for (const auto& r : results) {
    if (!r.has_forces()) continue;
    const bool prescribed = r.json.at("scene").contains("normal_force_mean");
    const auto radius = [&](const char* side, const char* key) { return length_text(r, side, key); };
    table.rows.push_back({r.name(), radius("scene", "contact_radius_unworn"), radius("mdr", "stick_radius_first_slip"),
                          radius("fe", "stick_radius_first_slip"), radius("mdr", "stick_radius_shakedown"),
                          radius("fe", "stick_radius_shakedown"),
                          difference_with_bar(r, prescribed ? "indentation_max" : "normal_force_max"),
                          difference_with_bar(r, "tangential_amplitude"), words_cell(gross_slip_text(r))});
  }
  if (table.rows.empty()) return nullptr;
  return {{"template", "forces"}, {"table", filling_of(table)}};
}

}  // namespace fretval
