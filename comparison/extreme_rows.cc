#include "comparison/extreme_rows.h"

#include <algorithm>
#include <iterator>

namespace fretval {
namespace {

template <class Property>
std::vector<ExtremeRow> chosen(const std::vector<ExtremeRow>& rows, Property property) {
  std::vector<ExtremeRow> some;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(some), property);
  return some;
}

}  // namespace

std::vector<ExtremeRow> extreme_rows() {
  std::vector<ExtremeRow> all;
  for (auto&& theme : {extreme_material_rows(), extreme_motion_rows(), extreme_shape_rows(), extreme_numerics_rows(),
                       extreme_bad_input_rows()})
    all.insert(all.end(), theme.begin(), theme.end());
  return all;
}

std::vector<ExtremeRow> short_extreme_rows() {
  return chosen(extreme_rows(), [](const ExtremeRow& row) { return row.in_short; });
}

std::vector<ExtremeRow> only_family(const std::vector<ExtremeRow>& rows, const std::string& text) {
  return chosen(rows, [&](const ExtremeRow& row) { return row.family.find(text) != std::string::npos; });
}

}  // namespace fretval
