#include "comparison/results/measured_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/quantities/readings_json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Value = Case::Measured::Value;

/// Area of a closed loop by trapezoids.
double area_of(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t next = (i + 1) % x.size();
    sum += (x[next] - x[i]) * (y[i] + y[next]) / 2;
  }
  return std::abs(sum);
}

double largest_of_all(const std::vector<double>& values, bool absolute) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, absolute ? std::abs(value) : value);
  return largest;
}

std::map<Quantity, Value> values_of(const Case& input) {
  const auto& measured = *input.measured;
  const auto kind = motion_kind_of(input.motion);
  std::map<Quantity, Value> values;
  if (measured.stick_radius) values[lasting_stick_radius(kind)] = *measured.stick_radius;
  if (measured.contact_radius) values[Quantity::contact_radius_max] = *measured.contact_radius;
  if (!measured.normal_force.empty())
    values[Quantity::normal_force_max] = {largest_of_all(measured.normal_force, false), 0};
  if (!measured.tangential_force.empty())
    values[Quantity::tangential_force_max] = {largest_of_all(measured.tangential_force, true), 0};
  if (!is_pass(kind) && !measured.tangential_force.empty() && !measured.tangential_displacement.empty())
    values[Quantity::tangential_work] = {area_of(measured.tangential_displacement, measured.tangential_force), 0};
  return values;
}

}  // namespace

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
