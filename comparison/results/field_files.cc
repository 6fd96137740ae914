#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "comparison/results/case_result.h"
#include "comparison/results/period_steps.h"
#include "comparison/support/files.h"
#include "comparison/support/parallel.h"
#include "fem/condensation/vtu_file.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

constexpr int n_instants_of_cycle = 24;
constexpr unsigned n_sectors = 96;
constexpr const char *section_series = "fields.pvd", *surface_series = "surface.pvd";

void remove_earlier(const fs::path& folder) {
  for (const char* series : {section_series, surface_series}) fs::remove(folder / series);
  if (!fs::is_directory(folder / "fields")) return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "fields")) {
    const auto name = entry.path().filename().string();
    const bool ours = name.rfind("section-", 0) == 0 || name.rfind("surface-", 0) == 0;
    if (ours && entry.path().extension() == ".vtu") files.push_back(entry.path());
  }
  for (const auto& file : files) fs::remove(file);
}

/// Columns of the last period, evenly spaced up to its end; or those of the smallest and the largest indentation.
std::vector<PeriodStep> instants_of(const FeAnswer& fe, Case::Fields fields) {
  const Eigen::Index n = fe.friction.traction.cols();
  std::vector<PeriodStep> instants;
  if (fields == Case::Fields::cycle) {
    for (const auto column : columns_at_equal_times(fe, n_instants_of_cycle)) instants.push_back({fe, column});
    return instants;
  }
  const auto depth = [&](Eigen::Index k) { return fe.normal.indentation[PeriodStep{fe, k}.normal_column()]; };
  Eigen::Index lowest = 0, deepest = 0;
  for (Eigen::Index k = 1; k < n; ++k) {
    if (depth(k) < depth(lowest)) lowest = k;
    if (depth(k) > depth(deepest)) deepest = k;
  }
  instants.push_back({fe, std::min(lowest, deepest)});
  if (lowest != deepest) instants.push_back({fe, std::max(lowest, deepest)});
  return instants;
}

/// One harmonic at all instants, a column each.
struct HarmonicCourse {
  const HarmonicBody& body;
  Eigen::MatrixXd moved, stressed;

  HarmonicCourse(const HarmonicBody& harmonic, const Eigen::MatrixXd& displacements, const Eigen::MatrixXd& tractions)
      : body(harmonic) {
    const auto n = tractions.cols();
    Eigen::MatrixXd both(tractions.rows(), 2 * n);
    both << fem::tractions_for(body.contact.compliance, displacements), tractions;
    const auto fields = fem::body_under(body.space, body.condensation, both);
    moved = fields.leftCols(n);
    stressed = fields.rightCols(n);
  }

  [[nodiscard]] fem::HarmonicState at(std::size_t instant) const {
    const auto k = static_cast<Eigen::Index>(instant);
    return {body.space, moved.col(k), stressed.col(k)};
  }
};

std::vector<HarmonicCourse> courses_of(const FeAnswer& fe, const std::vector<PeriodStep>& instants, const Body& body) {
  std::vector<Eigen::Index> normal, tangential;
  for (const auto& instant : instants) {
    normal.push_back(instant.normal_column());
    tangential.push_back(instant.column);
  }
  std::vector<HarmonicCourse> courses;
  courses.emplace_back(body.normal, fe.normal.displacement(Eigen::all, normal), fe.normal.pressure(Eigen::all, normal));
  if (body.tangential)
    courses.emplace_back(*body.tangential, fe.friction.displacement(Eigen::all, tangential),
                         fe.friction.traction(Eigen::all, tangential));
  return courses;
}

fem::RingTractions tractions_at(const PeriodStep& instant, double friction_coefficient) {
  fem::RingTractions rings{
      instant.fe.normal.pressure.col(instant.normal_column()), instant.fe.friction.traction.col(instant.column), {}};
  for (Eigen::Index i = 0; i < rings.pressure.size(); ++i)
    rings.zones.push_back(zone_of(rings.pressure[i], rings.traction[i], friction_coefficient));
  return rings;
}

template <class Write>
void write_text(const fs::path& file, const Write& write) {
  std::ostringstream text;
  write(text);
  write_file(file, text.str());
}

std::string file_name(const char* what, std::size_t instant) {
  return fmt::format("fields/{}-{:02}.vtu", what, instant);
}

void write_series(const char* what, const std::vector<PeriodStep>& instants, const FemCase& fem_case,
                  const fs::path& file) {
  std::vector<fem::SeriesStep> steps;
  for (std::size_t i = 0; i < instants.size(); ++i)
    steps.emplace_back(fem_case.first_row + instants[i].time() / fem_case.units.angular_frequency, file_name(what, i));
  write_text(file, [&](std::ostream& stream) { fem::write_pvd(steps, stream); });
}

}  // namespace

void write_field_files(const FeAnswer& fe, const FemCase& fem_case, Case::Fields fields, const fs::path& folder) {
  remove_earlier(folder);
  if (fields == Case::Fields::none || fe.as<GrossSlipStart>()) return;
  fs::create_directories(folder / "fields");
  std::optional<Body> made;
  if (!fe.whole_body) made.emplace(make_body(fem_case.body, {}));
  const auto& units = fem_case.units;
  const fem::FieldUnits field_units{units.length, units.depth, units.pressure()};
  const auto instants = instants_of(fe, fields);
  const auto courses = courses_of(fe, instants, made ? *made : *fe.whole_body);
  for_each_in_parallel(instants.size(), [&](std::size_t i) {
    fem::BodyState state{courses[0].at(i), std::nullopt};
    if (courses.size() > 1) state.tangential.emplace(courses[1].at(i));
    write_text(folder / file_name("section", i),
               [&](std::ostream& stream) { fem::write_meridian_section(state, field_units, stream); });
    const auto rings = tractions_at(instants[i], fem_case.friction_coefficient);
    write_text(folder / file_name("surface", i), [&](std::ostream& stream) {
      fem::write_revolved_surface(state, rings, field_units, n_sectors, stream);
    });
  });
  write_series("section", instants, fem_case, folder / section_series);
  write_series("surface", instants, fem_case, folder / surface_series);
}

}  // namespace fretval
