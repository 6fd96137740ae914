#include "mdr/support/csv_units.h"

#include <stdexcept>

namespace fretval::mdr {

namespace {

std::string without_brackets(const std::string& text) {
  const std::size_t begin = text.find_last_of("[(");
  const std::size_t end = text.find_last_of("])");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return text;
  return text.substr(begin + 1, end - begin - 1);
}

}  // namespace

const std::map<std::string, double>& length_units() {
  // Micro as the sign of its own and as the Greek letter.
  static const std::map<std::string, double> sizes{{"m", 1},     {"mm", 1e-3},      {"um", 1e-6},
                                                   {"nm", 1e-9}, {"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}};
  return sizes;
}

bool names_unit(const CsvColumns& csv, std::size_t column) {
  return !csv.units.empty() || (!csv.names.empty() && without_brackets(csv.names[column]) != csv.names[column]);
}

double unit_of_column(const CsvColumns& csv, std::size_t column, const std::map<std::string, double>& known,
                      const std::string& source_name) {
  if (!names_unit(csv, column)) return 1;
  const std::string name = without_brackets(csv.units.empty() ? csv.names[column] : csv.units[column]);
  const auto entry = known.find(name);
  if (entry != known.end()) return entry->second;
  std::string valid;
  for (const auto& [unit_name, size] : known) valid += (valid.empty() ? "" : ", ") + unit_name;
  throw std::invalid_argument(source_name + ": unit of column " + std::to_string(column + 1) + " = \"" + name +
                              "\": must be one of " + valid);
}

}  // namespace fretval::mdr
