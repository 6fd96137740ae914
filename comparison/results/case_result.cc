#include "comparison/results/case_result.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/reference/half_space.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/results/period_steps.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/support/files.h"
#include "comparison/support/versions.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json focus_by_quantity(const std::map<Quantity, Focus>& focus) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [quantity, one] : focus) json[name_of(quantity)] = focus_json(one);
  return json;
}

nlohmann::ordered_json run_json(const CaseResult& result) {
  nlohmann::ordered_json libraries;
  for (const auto& [name, version] : versions()) libraries[name] = version;
  const auto& normal = result.fe.fe.normal;
  const auto& q = result.fe.fe.body->mesh_quality;
  auto resolution = resolution_json(result.fem_case.resolution);
  resolution["focus"] = focus_by_quantity(result.fe.focus);
  resolution["refinements"] = result.fe.n_refinements;
  resolution["computations"] = result.fe.cost.computations;
  return {{"versions", libraries},
          {"resolution", resolution},
          {"reached",
           {{"periodicity_normal", normal.periodicity},
            {"periodicity_tangential", result.fe.fe.friction.periodicity},
            {"cycles_normal", normal.n_cycles}}},
          {"mesh",
           {{"cells", q.n_cells},
            {"nodes", q.n_nodes},
            {"min_scaled_jacobian", q.min_scaled_jacobian},
            {"max_aspect_ratio", q.max_aspect_ratio}}},
          {"units",
           {{"length", result.fem_case.units.length},
            {"depth", result.fem_case.units.depth},
            {"modulus", result.fem_case.units.modulus},
            {"angular_frequency", result.fem_case.units.angular_frequency}}}};
}

/// Normal force of a periodic response, or over a pass, at any time in s.
double force_at(const mdr::NormalResponse& response, double time) {
  const auto& times = response.time;
  const double t = time - times.back() * std::floor(time / times.back());
  const auto next = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  const auto k = static_cast<std::size_t>(next - times.begin());
  const double weight = (t - times[k - 1]) / (times[k] - times[k - 1]);
  return (1 - weight) * response.normal_force[k - 1] + weight * response.normal_force[k];
}

/// MDR's normal force at the times of the steps, N.
Eigen::VectorXd force_of_mdr(const CaseResult& result, const mdr::NormalResponse& reference) {
  const auto& fem = result.fem_case;
  Eigen::VectorXd force(result.fe.fe.friction.traction.cols());
  for (Eigen::Index k = 0; k < force.size(); ++k) {
    const double t = PeriodStep{result.fe.fe, k}.time();
    force[k] = fem.motion.normal_force ? fem::normal_motion(fem.motion, t).value * fem.units.force()
                                       : force_at(reference, t / fem.units.angular_frequency);
  }
  return force;
}

void write_history(const CaseResult& result, const mdr::NormalResponse& reference, const fs::path& file) {
  const auto& fem = result.fem_case;
  const auto& history = result.fe.fe.normal;
  const auto& friction = result.fe.fe.friction;
  const Eigen::Index n = friction.traction.cols();
  const auto& path = result.input.motion.path;
  const double rest = path ? rest_of(*path).tangential : 0;
  Eigen::VectorXd time(n), indentation(n), displacement(n), normal_force(n), tangential_force(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const PeriodStep step{result.fe.fe, k};
    time[k] = fem.first_row + step.time() / fem.units.angular_frequency;
    const auto column = step.normal_column();
    indentation[k] = history.indentation[column] * fem.units.depth;
    displacement[k] = rest + friction.indenter[k] * fem.units.depth;
    normal_force[k] = (history.force[column] + history.force_beyond[column]) * fem.units.force();
    tangential_force[k] = friction.force[k] * fem.units.force();
  }
  std::vector<Column> columns{
      {"t [s]", time}, {"d [m]", indentation}, {"u_x [m]", displacement}, {"F_N [N]", normal_force}};
  if (result.is_compared()) columns.push_back({"F_N MDR [N]", force_of_mdr(result, reference)});
  columns.push_back({"F_x [N]", tangential_force});
  write_csv(file, columns);
}

/// A ring that is never touched in the period moves against the indenter, and does not slip: nan.
Eigen::VectorXd slip_where_touched(const CaseResult& result) {
  const Eigen::VectorXd pressure = result.fe.fe.normal.pressure.rowwise().maxCoeff();  // it keeps one cycle
  Eigen::VectorXd slip = result.fem_case.units.depth * result.fe.fe.friction.period_slip;
  for (Eigen::Index i = 0; i < slip.size(); ++i)
    if (pressure[i] <= 0) slip[i] = std::nan("");
  return slip;
}

void write_contact(const CaseResult& result, const fs::path& file) {
  const auto& normal = result.fe.fe.normal;
  const auto& units = result.fem_case.units;
  const auto& friction = result.fe.fe.friction;
  const auto last_cycle = normal.pressure.rightCols(normal.steps_per_cycle);
  const auto n = static_cast<Eigen::Index>(result.fe.fe.body->radii.size()) - 1;
  const Eigen::Map<const Eigen::VectorXd> radii(result.fe.fe.body->radii.data(), n + 1);
  write_csv(file, {{"r inner [m]", units.length * radii.head(n)},
                   {"r outer [m]", units.length * radii.tail(n)},
                   {"p smallest [Pa]", units.pressure() * last_cycle.rowwise().minCoeff()},
                   {"p largest [Pa]", units.pressure() * last_cycle.rowwise().maxCoeff()},
                   {"tau smallest [Pa]", units.pressure() * friction.traction.rowwise().minCoeff()},
                   {"tau largest [Pa]", units.pressure() * friction.traction.rowwise().maxCoeff()},
                   {"surface height at d max [m]",
                    units.depth * (normal.largest_indentation - normal.deepest_displacement.array()).matrix()},
                   {"slip per period [m]", slip_where_touched(result)},
                   {"first slip margin [Pa]", units.pressure() * friction.first_slip_margin},
                   {"shakedown margin [Pa]", units.pressure() * friction.shakedown_margin}});
}

void write_profile(const CaseResult& result, const fs::path& file) {
  constexpr Eigen::Index n = 400;
  const auto& mdr = result.mdr_case;
  const auto worn = worn_profile(mdr, result.mdr.stick_radius_shakedown);
  const double wanted = 1.1 * (worn ? worn->outer_radius : result.fem_case.units.length),
               end = result.is_compared() ? wanted : std::min(wanted, mdr::end_radius(mdr.profile));
  const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(n, 0, end);
  Eigen::VectorXd unworn(n), limiting(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    unworn[i] = mdr::shape(mdr.profile, r[i]);
    if (worn) limiting[i] = mdr::shape(*worn, r[i]);
  }
  std::vector<Column> columns{{"r [m]", r}, {"f unworn [m]", unworn}};
  if (worn) columns.push_back({"f limiting [m]", limiting});
  write_csv(file, columns);
}

void write_periodic_state(const CaseResult& result, const mdr::NormalResponse& reference, const fs::path& folder) {
  if (result.fe.fe.as<GrossSlipStart>()) return;
  if (result.fe.fe.as<SurfaceAnswer>()) return write_surface_files(result.fe.fe, result.fem_case, folder);
  write_history(result, reference, folder / "history.csv");
  write_contact(result, folder / "contact.csv");
  write_file(folder / "cycle.json", cycle_json(result).dump() + "\n");
}

/// Names of files may have bytes that are not UTF-8.
std::string as_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

Outcome outcome_of(const CaseResult& result) {
  if (!result.is_compared()) return Outcome::not_compared;
  if (!beyond_mdr_model(result.input).empty()) return Outcome::other_model;
  if (const auto sliding = outcome_of_sliding(result.input, result.fe.fe, result.mdr)) return *sliding;
  return outcome_of(result.comparison);
}

CaseResult result_of(const PreparedCase& prepared, MdrAnswers&& mdr, Proof proof, ProvedAnswer&& fe) {
  CaseResult result{prepared.input,
                    prepared.mdr,
                    at_resolution(prepared.fem, fe.resolution),
                    std::move(mdr.own),
                    proof,
                    std::move(fe),
                    {}};
  if (!result.is_compared()) return result;
  if (result.fe.fe.cycles_to_shakedown && proof != Proof::none)
    result.mdr.cycles_to_shakedown = settling_cycles(result.mdr_case, result.mdr, result.fe.resolution.n_ramp_cycles);
  if (!prepared.input.body.is_half_space()) result.half_space = mdr.half_space ? std::move(mdr.half_space) : result.mdr;
  result.rings = given_rings_of(prepared, result.fe);
  result.model = model_errors_of(prepared.input, result.mdr);
  const auto& fem = prepared.fem;
  result.comparison = compare(readings_of(result.fe.fe, fem.units), compared_readings_of(result.mdr),
                              scales_of(result.mdr, fem.units.length), prepared.tolerances, result.fe.budget);
  if (!beyond_mdr_model(result.input).empty())
    for (auto& [quantity, difference] : result.comparison) difference.verdict.reset();
  return result;
}

void add_wear(ProvedWear&& wear, CaseResult& result) {
  result.comparison.insert(wear.comparison.begin(), wear.comparison.end());
  result.wear = std::move(wear);
}

void withdraw_result(const fs::path& folder) {
  fs::remove(folder / "result.json");
}

void write_result(const CaseResult& result, const nlohmann::ordered_json& json, const mdr::NormalResponse& reference,
                  const fs::path& folder) {
  fs::create_directories(folder);
  write_profile(result, folder / "profile.csv");
  write_moduli(result.input, result.mdr_case.body, folder);
  write_data(result.input, folder);
  write_periodic_state(result, reference, folder);
  write_field_files(result.fe.fe, result.fem_case, result.input.fields.value_or(Case::Fields::none), folder);
  if (result.wear) write_wear(*result.wear, result.input, result.fem_case.units, folder);
  if (result.surface_wear) write_surface_wear(*result.surface_wear, result.fem_case.units, folder);
  write_file(folder / "run.json", as_text(run_json(result)));
  write_file(folder / "result.json", as_text(json));
}

}  // namespace fretval
