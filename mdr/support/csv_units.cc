#include "mdr/support/csv_units.h"

#include <stdexcept>

namespace fretval::mdr {

std::string unit_text(const std::string& text) {
  const std::size_t begin = text.find_last_of("[(");
  const std::size_t end = text.find_last_of("])");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return text;
  return text.substr(begin + 1, end - begin - 1);
}

const std::map<std::string, double>& length_units() {
  // Micro as the sign of its own and as the Greek letter.
  static const std::map<std::string, double> sizes{{"m", 1},     {"cm", 1e-2},      {"mm", 1e-3},     {"um", 1e-6},
                                                   {"nm", 1e-9}, {"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}};
  return sizes;
}

const std::map<std::string, double>& modulus_units() {
  static const std::map<std::string, double> sizes{{"Pa", 1},    {"kPa", 1e3},    {"MPa", 1e6},
                                                   {"GPa", 1e9}, {"N/mm^2", 1e6}, {"N/mm\u00b2", 1e6}};
  return sizes;
}

const std::map<std::string, double>& time_units() {
  static const std::map<std::string, double> sizes{{"s", 1},          {"sec", 1},        {"ms", 1e-3}, {"us", 1e-6},
                                                   {"\u00b5s", 1e-6}, {"\u03bcs", 1e-6}, {"min", 60},  {"h", 3600}};
  return sizes;
}

const std::map<std::string, double>& force_units() {
  static const std::map<std::string, double> sizes{{"N", 1},     {"kN", 1e3},       {"MN", 1e6},       {"mN", 1e-3},
                                                   {"uN", 1e-6}, {"\u00b5N", 1e-6}, {"\u03bcN", 1e-6}, {"nN", 1e-9}};
  return sizes;
}

const std::map<std::string, double>& ratio_units() {
  static const std::map<std::string, double> sizes{{"", 1}, {"-", 1}, {"1", 1}, {"%", 1e-2}};
  return sizes;
}

bool names_unit(const CsvColumns& csv, std::size_t column) {
  if (!csv.units.empty() && !csv.units[column].empty()) return true;
  return !csv.names.empty() && unit_text(csv.names[column]) != csv.names[column];
}

double unit_of_column(const CsvColumns& csv, std::size_t column, const std::map<std::string, double>& known,
                      const std::string& source_name) {
  if (!names_unit(csv, column)) return 1;
  const bool beside_name = csv.units.empty() || csv.units[column].empty();
  const std::string name = unit_text(beside_name ? csv.names[column] : csv.units[column]);
  const auto entry = known.find(name);
  if (entry != known.end()) return entry->second;
  std::string valid;
  for (const auto& [unit_name, size] : known) valid += (valid.empty() ? "" : ", ") + unit_name;
  throw std::invalid_argument(source_name + ": unit of column " + std::to_string(column + 1) + " = \"" + name +
                              "\": must be one of " + valid);
}

}  // namespace fretval::mdr
