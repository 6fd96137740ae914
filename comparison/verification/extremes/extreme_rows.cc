#include "comparison/verification/extremes/extreme_rows.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace fretval {
namespace {

bool in_short_form(const ExtremeRow& row) {
  static const std::set<std::pair<std::string, std::string>> rows{
      {"relaxation time, standard solid", "omega tau = 1e-06"},
      {"relaxation time, standard solid", "omega tau = 1e+06"},
      {"viscosity, Kelvin-Voigt", "omega eta/G0 = 1e-06"},
      {"softening, omega tau = 1", "G0/Ginf = 0.0001"},
      {"softening, omega tau = 1e6", "G0/Ginf = 1e-06"},
      {"friction, amplitude kept", "mu = 0.0001"},
      {"friction, amplitude kept", "mu = 1000"},
      {"length", "a = 1 nm"},
      {"tangential amplitude over sliding", "0.5"},
      {"tangential amplitude over sliding", "2"},
      {"normal amplitude, elastic", "Dd/d0 = 0.999"},
      {"normal amplitude, elastic", "Dd/d0 = 2"},
      {"border of no stick", "elastic"},
      {"all stick", "u_x0 = 0"},
      {"in phase, elastic", "phi0 = 0, k = 1"},
      {"power law", "n = 1"},
      {"measured profile", "terrace"},
      {"frequency ratio", "f_x/f_z = 0.5"},
      {"frequency ratio", "f_x/f_z = 1000"},
      {"steps per cycle", "15"},
      {"rings per radius", "15"},
      {"cycles", "1 at least"},
      {"refused input", "Friction / Coefficient = 0"}};
  return rows.count({row.family, row.value}) > 0;
}

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
  return chosen(extreme_rows(), in_short_form);
}

std::vector<ExtremeRow> only_family(const std::vector<ExtremeRow>& rows, const std::string& text) {
  return chosen(rows, [&](const ExtremeRow& row) { return row.family.find(text) != std::string::npos; });
}

}  // namespace fretval
