#include "comparison/verification/extremes/extreme_rows.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace fretval {
namespace {

template <class Property>
std::vector<ExtremeRow> chosen(const std::vector<ExtremeRow>& rows, Property property) {
  std::vector<ExtremeRow> some;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(some), property);
  return some;
}

}  // namespace

Entries extremes_base() {
  Entries entries{{"Friction / Coefficient", "0.5"},      {"Friction / Law", "unidirectional"},
                  {"Motion / Indentation", "1e-4"},       {"Motion / Normal amplitude", "2e-5"},
                  {"Motion / Normal frequency", "1"},     {"Motion / Tangential amplitude", "1.5e-5"},
                  {"Motion / Tangential frequency", "1"}, {"Motion / Phase", "60"},
                  {"Accuracy / Tolerance", "1e-2"}};
  return with(with(entries, parabola(1e-2)), branches("standard solid", 1e6, {1}, {0.1}));
}

Entries elastic_base() {
  return with_section(extremes_base(), elastic(1e6));
}

std::vector<ExtremeRow> extreme_rows() {
  std::vector<ExtremeRow> all;
  for (auto&& theme : {extreme_material_rows(), extreme_motion_rows(), extreme_shape_rows(), extreme_numerics_rows(),
                       extreme_bad_input_rows()})
    all.insert(all.end(), theme.begin(), theme.end());
  return all;
}

std::vector<ExtremeRow> short_extreme_rows() {
  std::set<std::string> seen;
  return chosen(extreme_rows(), [&](const ExtremeRow& row) { return seen.insert(row.family).second; });
}

std::vector<ExtremeRow> only_family(const std::vector<ExtremeRow>& rows, const std::string& text) {
  return chosen(rows, [&](const ExtremeRow& row) { return row.family.find(text) != std::string::npos; });
}

}  // namespace fretval
