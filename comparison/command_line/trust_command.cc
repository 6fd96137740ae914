#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case_file/case_file.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/report/report.h"
#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "comparison/support/stopwatch.h"
#include "comparison/trust/ladder_text.h"
#include "comparison/trust/map.h"
#include "fem/condensation/petsc_session.h"

namespace fretval {

double share_of(const std::string& text, const char* option) {
  std::size_t end = 0;
  double value = std::nan("");
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  const auto rest = text.substr(end);
  const bool in_percent = rest == "%" || rest == " %";
  if (!(value >= 0) || !std::isfinite(value) || (!rest.empty() && !in_percent))
    throw InputError(fmt::format("{} {}: expected a share that is not negative, as \"5 %\" or 0.05", option, text));
  return in_percent ? value / 100 : value;
}

int run_trust(const std::string& file, const TrustOptions& options) {
  const auto cases = read_case_file(file);
  if (cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many ladders; expected a file with a single case", file));
  const auto& input = cases.front();
  for (const auto& warning : input.warnings) log::warn_once(warning);
  const fem::PetscSession session;
  BodyStore bodies(store_of(options.store));
  const auto ladder = ladder_of(input, bodies);
  if (options.json)
    fmt::print("{}\n", ladder_json(input, ladder).dump(2));
  else
    fmt::print("{}", ladder_text(input.name, ladder));
  if (!options.output.empty()) {
    const auto folder = std::filesystem::path(options.output);
    std::filesystem::create_directories(folder);
    write_file(folder / "trust.json", ladder_json(input, ladder).dump(2) + "\n");
    log::info(fmt::format("report: {}", write_report(folder).string()));
  }
  if (!options.at_most) return exit_agree;
  const auto beyond = radii_beyond(*options.at_most, ladder);
  if (beyond.empty()) return exit_agree;
  log::warn(fmt::format("{}: MDR is off by more than {:g} %: {}", input.name, 100 * *options.at_most, beyond));
  return exit_disagree;
}

int run_map(const TrustOptions& options) {
  prepare_output_file("--map", options.map);
  const auto earlier = content_of(options.map);
  const auto known = earlier.empty() ? std::vector<MapPoint>{} : points_of_csv(earlier);
  const fem::PetscSession session;
  BodyStore bodies(store_of(options.store));
  const auto planned = planned_points();
  const auto n_missing = [](const std::vector<MapPoint>& points) {
    return std::count_if(points.begin(), points.end(), [](const MapPoint& point) { return point.changes.empty(); });
  };
  Stopwatch watch;
  const auto points =
      computed_map(planned, known, bodies, [&](const std::vector<MapPoint>& so_far, std::size_t computed) {
        write_file(options.map, csv_of(so_far));
        const auto& point = so_far[computed];
        log::info(fmt::format("{}: c/a = {:.2f}; {} of {} points left", point.map, point.at.shakedown.value_or(0),
                              n_missing(so_far), planned.size()));
      });
  write_file(options.map, csv_of(points));
  log::info(fmt::format("{}: {} points in {:.0f} s", options.map, points.size(), watch.lap()));
  return n_missing(points) > 0 ? exit_numerics_failed : exit_agree;
}

}  // namespace fretval
