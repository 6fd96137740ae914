#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "comparison/case/oscillations.h"
#include "comparison/quantities/reading.h"
#include "comparison/results/case_result.h"
#include "comparison/support/constants.h"
#include "comparison/support/files.h"
#include "comparison/support/statistics.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Values = std::vector<double>;
using Value = Case::Measured::Value;

Eigen::VectorXd vector_of(const Values& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A column with some of the rows: more would not be seen.
Column some_rows(const char* name, const Values& values) {
  constexpr std::size_t most_rows = 2000;
  return {name, vector_of(thinned(values, most_rows))};
}

/// What the aligned profile, linear between its rows, leaves of each row of the trace; NaN beyond it.
Values residuals_of(const Case::AlignedTrace& trace) {
  Values residuals;
  const double sign = trace.heights_upwards ? -1 : 1;
  double mean = 0, n = 0;
  for (std::size_t i = 0; i < trace.x.size(); ++i) {
    const double u = trace.x[i] - trace.apex, r = std::abs(u);
    const auto above = std::upper_bound(trace.r.begin(), trace.r.end(), r);
    if (above == trace.r.begin() || above == trace.r.end()) {
      residuals.push_back(std::nan(""));
      continue;
    }
    const auto k = static_cast<std::size_t>(above - trace.r.begin());
    const double share = (r - trace.r[k - 1]) / (trace.r[k] - trace.r[k - 1]);
    residuals.push_back(sign * (trace.z[i] - trace.tilt * u) -
                        (trace.f[k - 1] + share * (trace.f[k] - trace.f[k - 1])));
    mean += residuals.back();
    ++n;
  }
  for (double& one : residuals) one -= n > 0 ? mean / n : 0;
  return residuals;
}

ordered_json trace_json(const Case::AlignedTrace& trace) {
  return {{"apex", trace.apex},
          {"apex_uncertainty", trace.apex_uncertainty},
          {"tilt", std::atan(trace.tilt) * degrees_per_radian},
          {"tilt_uncertainty", trace.tilt_uncertainty * degrees_per_radian},
          {"noise", trace.noise},
          {"heights", trace.heights_upwards ? "upwards" : "downwards"},
          {"rows", trace.x.size()}};
}

ordered_json record_json(const Case::Path& path) {
  const auto& reduction = *path.reduction;
  return {{"rows", reduction.n_rows},
          {"rows_kept", path.time.size()},
          {"rows_before_contact", reduction.n_cut},
          {"normal_error", reduction.normal_error},
          {"tangential_error", reduction.tangential_error},
          {"cycles", reduction.n_cycles},
          {"normal_scatter", reduction.normal_scatter},
          {"tangential_scatter", reduction.tangential_scatter}};
}

ordered_json test_json(const Case::TestDuration& test) {
  return {{"duration", test.seconds},
          {"relaxed_modulus_of_data", test.relaxed_modulus},
          {"branches_of_data", test.branch_times.size()},
          {"slow_branches", test.n_slow},
          {"merged_branches", test.n_fast},
          {"merging_error", test.merging_error},
          {"near_times", test.near_times}};
}

const double radians_per_cycle = 2 * pi;
constexpr Eigen::Index n_frequencies = 121;

std::vector<double> frequencies_of_interest(const Case& input, const mdr::PronyBody& body) {
  std::vector<double> all;
  for (const double time : body.branch_times) all.push_back(1 / (radians_per_cycle * time));
  if (body.viscosity > 0) all.push_back(body.relaxed_modulus / (radians_per_cycle * body.viscosity));
  if (!input.motion.path)
    for (const double frequency : moving_frequencies(input.motion)) all.push_back(frequency);
  if (const auto& curve = input.elastomer.master_curve)
    all.insert(all.end(), curve->frequency.begin(), curve->frequency.end());
  return all;
}

/// Area of a closed loop by trapezoids.
double area_of(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t next = (i + 1) % x.size();
    sum += (x[next] - x[i]) * (y[i] + y[next]) / 2;
  }
  return std::abs(sum);
}

std::map<Quantity, Value> values_of(const Case& input) {
  const auto& measured = *input.measured;
  const auto kind = motion_kind_of(input.motion);
  std::map<Quantity, Value> values;
  if (measured.stick_radius) values[lasting_stick_radius(kind)] = *measured.stick_radius;
  if (measured.contact_radius) values[Quantity::contact_radius_max] = *measured.contact_radius;
  if (!measured.normal_force.empty())
    values[Quantity::normal_force_max] = {
        std::max(0.0, *std::max_element(measured.normal_force.begin(), measured.normal_force.end())), 0};
  if (!measured.tangential_force.empty())
    values[Quantity::tangential_force_max] = {largest_size(measured.tangential_force), 0};
  if (!is_pass(kind) && !measured.tangential_force.empty() && !measured.tangential_displacement.empty())
    values[Quantity::tangential_work] = {area_of(measured.tangential_displacement, measured.tangential_force), 0};
  return values;
}

}  // namespace

void write_data(const Case& input, const std::filesystem::path& folder) {
  if (const auto& trace = input.indenter.trace) {
    write_csv(folder / "trace.csv", {some_rows("x [m]", trace->x), some_rows("z [m]", trace->z),
                                     some_rows("residual [m]", residuals_of(*trace))});
    write_csv(folder / "aligned_profile.csv", {some_rows("r [m]", trace->r), some_rows("f [m]", trace->f)});
  }
  if (!input.measured || input.measured->loop.empty()) return;
  const auto& measured = *input.measured;
  std::vector<Column> columns;
  for (const auto& [name, values] : {std::pair<const char*, const Values*>{"t [s]", &measured.time},
                                     {"d [m]", &measured.indentation},
                                     {"u_x [m]", &measured.tangential_displacement},
                                     {"F_N [N]", &measured.normal_force},
                                     {"F_x [N]", &measured.tangential_force}})
    if (!values->empty()) columns.push_back(some_rows(name, *values));
  write_csv(folder / "measured_loops.csv", columns);
}

ordered_json data_json(const Case& input) {
  ordered_json json = ordered_json::object();
  if (const auto& trace = input.indenter.trace) json["trace"] = trace_json(*trace);
  if (const auto& path = input.motion.path; path && path->reduction) json["record"] = record_json(*path);
  if (const auto& test = input.elastomer.test_duration) json["test_duration"] = test_json(*test);
  if (input.elastomer.shore_a)
    json["hardness"] = {{"shore_a", *input.elastomer.shore_a}, {"scatter", input.elastomer.modulus_scatter}};
  return json;
}

void write_moduli(const Case& input, const mdr::PronyBody& body, const std::filesystem::path& folder) {
  if (body.branch_times.empty() && !(body.viscosity > 0)) return;
  const auto all = frequencies_of_interest(input, body);
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  const Eigen::VectorXd f =
      Eigen::ArrayXd::LinSpaced(n_frequencies, std::log(*least / 10), std::log(*most * 10)).exp().matrix();
  Eigen::VectorXd storage(n_frequencies), loss(n_frequencies);
  for (Eigen::Index i = 0; i < n_frequencies; ++i) {
    const auto modulus = mdr::complex_modulus(body, radians_per_cycle * f[i]);
    storage[i] = modulus.real();
    loss[i] = modulus.imag();
  }
  write_csv(folder / "moduli.csv", {{"f [Hz]", f}, {"G' [Pa]", storage}, {"G'' [Pa]", loss}});
  if (const auto& curve = input.elastomer.master_curve)
    write_csv(folder / "measured_moduli.csv", {{"f [Hz]", vector_of(curve->frequency)},
                                               {"G' [Pa]", vector_of(curve->storage)},
                                               {"G'' [Pa]", vector_of(curve->loss)}});
}

ordered_json measured_json(const Case& input, const ordered_json& fe, const ordered_json& mdr) {
  if (!input.measured) return nullptr;
  ordered_json json = ordered_json::object();
  for (const auto& [quantity, measured] : values_of(input)) {
    auto& one = json[name_of(quantity)] = {{"value", measured.value}, {"uncertainty", measured.uncertainty}};
    for (const auto& [method, answer] : {std::pair{"fe", &fe}, std::pair{"mdr", &mdr}}) {
      const auto reading = stored_reading(*answer, quantity);
      const bool has_value = reading && reading->value;
      one[method] = has_value ? ordered_json(*reading->value) : ordered_json(nullptr);
      one[std::string(method) + "_difference"] =
          has_value ? ordered_json(*reading->value - measured.value) : ordered_json(nullptr);
    }
  }
  return json;
}

}  // namespace fretval
