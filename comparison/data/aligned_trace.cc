#include "comparison/data/aligned_trace.h"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <utility>

#include "comparison/data/table_units.h"
#include "mdr/profiles/profile_csv.h"
#include "mdr/profiles/trace_alignment.h"

namespace fretval {
namespace {

/// Instruments scan both ways; places that repeat are of no use.
void sort_by_place(std::vector<double>& x, std::vector<double>& z) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  std::vector<double> sorted_x, sorted_z;
  double n_same = 1;
  for (const auto i : order) {
    if (!sorted_x.empty() && x[i] == sorted_x.back()) {
      sorted_z.back() += (z[i] - sorted_z.back()) / ++n_same;
      continue;
    }
    n_same = 1;
    sorted_x.push_back(x[i]);
    sorted_z.push_back(z[i]);
  }
  x = std::move(sorted_x);
  z = std::move(sorted_z);
}

Case::AlignedTrace trace_with(const mdr::TraceAlignment& alignment, std::vector<double> x, std::vector<double> z) {
  auto profile = mdr::aligned_profile(alignment, x, z);
  return {alignment, std::move(x), std::move(z), std::move(profile.r), std::move(profile.f), profile.noise};
}

}  // namespace

Case::AlignedTrace read_aligned_trace(const std::string& file, double table_noise) {
  return input_from(file, [&] {
    std::ifstream stream(file);
    auto chosen = mdr::read_columns(stream, file, mdr::profile_columns(), mdr::InOrder::yes);
    take_into_si(file, mdr::profile_columns(), chosen);
    auto x = std::move(chosen.csv.columns[0]), z = std::move(chosen.csv.columns[1]);
    sort_by_place(x, z);
    const auto alignment = mdr::align_trace(x, z);
    auto trace = trace_with(alignment, std::move(x), std::move(z));
    if (table_noise > 0) trace.row_noise *= table_noise / trace.noise;
    return trace;
  });
}

Case::AlignedTrace neighbour_of(const Case::AlignedTrace& trace, int deviations) {
  const auto neighbours = mdr::neighbours_of(trace, trace.x, trace.z);
  auto other = trace_with(neighbours[deviations < 0 ? 0 : 1], trace.x, trace.z);
  other.row_noise = trace.row_noise;
  return other;
}

}  // namespace fretval
