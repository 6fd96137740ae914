#include "comparison/results/data_files.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "comparison/support/constants.h"
#include "comparison/support/files.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Values = std::vector<double>;

constexpr std::size_t most_rows = 2000;

/// Some of the rows at equal distances: more would not be seen.
Eigen::VectorXd thinned(const Values& values) {
  const std::size_t stride = (values.size() + most_rows - 1) / most_rows;
  Values few;
  for (std::size_t i = 0; i < values.size(); i += std::max<std::size_t>(stride, 1)) few.push_back(values[i]);
  return Eigen::Map<const Eigen::VectorXd>(few.data(), static_cast<Eigen::Index>(few.size()));
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
  const double degrees = 180 / pi;
  return {{"apex", trace.apex},
          {"apex_uncertainty", trace.apex_uncertainty},
          {"tilt", std::atan(trace.tilt) * degrees},
          {"tilt_uncertainty", trace.tilt_uncertainty * degrees},
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

}  // namespace

void write_data(const Case& input, const std::filesystem::path& folder) {
  if (const auto& trace = input.indenter.trace) {
    write_csv(
        folder / "trace.csv",
        {{"x [m]", thinned(trace->x)}, {"z [m]", thinned(trace->z)}, {"residual [m]", thinned(residuals_of(*trace))}});
    write_csv(folder / "aligned_profile.csv", {{"r [m]", thinned(trace->r)}, {"f [m]", thinned(trace->f)}});
  }
  if (!input.measured || input.measured->loop.empty()) return;
  const auto& measured = *input.measured;
  std::vector<Column> columns;
  for (const auto& [name, values] : {std::pair<const char*, const Values*>{"t [s]", &measured.time},
                                     {"d [m]", &measured.indentation},
                                     {"u_x [m]", &measured.tangential_displacement},
                                     {"F_N [N]", &measured.normal_force},
                                     {"F_x [N]", &measured.tangential_force}})
    if (!values->empty()) columns.push_back({name, thinned(*values)});
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

}  // namespace fretval
