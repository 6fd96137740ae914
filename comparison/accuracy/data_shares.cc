#include "comparison/accuracy/data_shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "comparison/case/test_duration.h"
#include "comparison/data/aligned_trace.h"
#include "comparison/data/path_table.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/support/log.h"
#include "mdr/rheology/prony_fit.h"

namespace fretval {
namespace {

/// The case with a changed path, whose motion has the size of that path.
template <class Change>
Case with_path(Case input, const Change& change) {
  auto path = *input.motion.path;
  change(path);
  input.motion = motion_along(std::move(path));
  return input;
}

void stretch(std::vector<double>& values, double by) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double half = (*most - *least) / 2, middle = (*least + *most) / 2;
  if (!(half > 0)) return;
  for (double& value : values) value = middle + (value - middle) * (1 + by / half);
}

/// The case with a body that is fitted to G' alone.
Case by_storage_alone(Case input) {
  auto& body = input.elastomer;
  const auto& curve = *body.master_curve;
  mdr::PronyFitOptions options;
  options.storage_alone = true;
  options.branches_per_decade = 3;  // those of the fit to both are chosen by both
  const auto fitted = mdr::fit_prony({curve.frequency, curve.storage, curve.loss}, options).body;
  body.relaxed_modulus = fitted.relaxed_modulus;
  body.branch_moduli = fitted.branch_moduli;
  body.branch_times = fitted.branch_times;
  if (const auto test = std::exchange(body.test_duration, std::nullopt)) limit_to_test(test->seconds, input);
  return input;
}

/// Keeps a record that is in contact throughout in contact where its changed values would lift off.
void keep_contact(const std::vector<double>& as_recorded, double normal, std::vector<double>& values) {
  const double least = *std::min_element(as_recorded.begin(), as_recorded.end());
  if (!(least > 0) || least > normal) return;
  for (double& value : values) value = std::max(value, least);
}

/// A path that is off by the same everywhere, and one that is off in opposite directions at its extremes.
DataVariant variant_of_path(const Case& input, const char* what, double normal, double tangential) {
  DataVariant variant{what, {}};
  if (normal > 0)
    variant.cases.push_back(with_path(input, [&](Case::Path& path) {
      for (double& value : path.normal) value += normal;
      stretch(path.tangential, tangential);
      keep_contact(input.motion.path->normal, normal, path.normal);
    }));
  variant.cases.push_back(with_path(input, [&](Case::Path& path) {
    stretch(path.normal, normal);
    stretch(path.tangential, tangential);
    keep_contact(input.motion.path->normal, normal, path.normal);
  }));
  return variant;
}

Readings readings_of_case(const MdrCase& mdr) {
  return readings_of(mdr_answer(mdr, mdr_normal_response(mdr)));
}

}  // namespace

std::vector<DataVariant> data_variants(const Case& input) {
  std::vector<DataVariant> variants;
  if (const auto& trace = input.indenter.trace) {
    DataVariant variant{"alignment of the trace", {}};
    for (const int side : {-1, 1}) {
      variant.cases.push_back(input);
      variant.cases.back().indenter.trace = neighbour_of(*trace, side);
    }
    variants.push_back(std::move(variant));
  }
  if (const auto& path = input.motion.path; path && path->reduction) {
    const auto& r = *path->reduction;
    variants.push_back(variant_of_path(input, "what was left out of the record", r.normal_error, r.tangential_error));
    if (r.normal_scatter > 0 || r.tangential_scatter > 0)
      variants.push_back(variant_of_path(input, "scatter from cycle to cycle", r.normal_scatter, r.tangential_scatter));
  }
  if (input.elastomer.modulus_scatter > 0) {
    DataVariant variant{"scatter of the modulus", {input}};
    variant.cases.back().elastomer.relaxed_modulus *= 1 + input.elastomer.modulus_scatter;
    variants.push_back(std::move(variant));
  }
  if (const auto& curve = input.elastomer.master_curve;
      curve && curve->kramers_kronig && !curve->kramers_kronig->consistent)
    variants.push_back({"contradiction of G' and G''", {by_storage_alone(input)}});
  return variants;
}

Quantities data_uncertainties(const Case& input, const MdrCase& mdr) {
  Quantities uncertainties;
  const auto variants = data_variants(input);
  if (variants.empty() || !mdr.falls().empty()) return uncertainties;
  const auto answer = mdr_answer(mdr, mdr_normal_response(mdr));
  const auto as_it_is = readings_of(answer);
  const auto scales = scales_of(answer, unworn_radius_at(mdr, deepest_indentation(mdr)));
  for (const auto& variant : variants) {
    Quantities farthest;
    for (const auto& one : variant.cases) try {
        for (const auto& [quantity, reading] : readings_of_case(mdr_case(one))) {
          const auto before = as_it_is.find(quantity);
          if (before == as_it_is.end()) continue;
          const auto change = difference_of(quantity, reading, before->second, scales);
          const double size =
              change ? std::abs(*change) : std::abs(only_one_of(quantity, reading, before->second, scales));
          farthest[quantity] = std::max(farthest[quantity], size);
        }
      } catch (const std::exception& error) {
        log::warn(fmt::format("{}: the bars do not have this share ({}): {}", input.name, variant.what, error.what()));
      }
    for (const auto& [quantity, size] : farthest) uncertainties[quantity] += size;
  }
  return uncertainties;
}

void add_data_shares(const Case& input, const MdrCase& mdr, ErrorBudget& budget) {
  if (budget.empty()) return;
  for (const auto& [quantity, size] : data_uncertainties(input, mdr))
    if (const auto bar = budget.find(quantity); bar != budget.end()) bar->second.add(ErrorSource::data, size);
}

}  // namespace fretval
