#include "mdr/rheology/modulus_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/csv_units.h"

namespace fretval::mdr {

namespace {

using Units = std::map<std::string, double>;

void scale(std::vector<double>& values, double size, const char* quantity, const CsvColumns& csv,
           const std::string& source_name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= size;
    require_positive(source_name + ", line " + std::to_string(csv.line_of_row[i]) + ": " + quantity, values[i]);
  }
}

// Rows in the order of frequency, those of the same frequency averaged.
ModulusTable ordered(const std::vector<std::vector<double>>& columns) {
  std::vector<std::size_t> order(columns[0].size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return columns[0][i] < columns[0][j]; });
  ModulusTable table;
  double n_same = 0;
  for (const std::size_t i : order) {
    if (table.frequency.empty() || columns[0][i] != table.frequency.back()) {
      table.frequency.push_back(columns[0][i]);
      table.storage.push_back(0);
      table.loss.push_back(0);
      n_same = 0;
    }
    ++n_same;
    table.storage.back() += (columns[1][i] - table.storage.back()) / n_same;
    table.loss.back() += (columns[2][i] - table.loss.back()) / n_same;
  }
  return table;
}

}  // namespace

void validate(const ModulusTable& table) {
  const std::size_t n = table.frequency.size();
  if (n < 2) reject("number of frequencies of the modulus table", static_cast<double>(n), "must be at least 2");
  if (table.storage.size() != n || table.loss.size() != n) {
    throw std::invalid_argument("modulus table of " + std::to_string(n) + " frequencies, " +
                                std::to_string(table.storage.size()) + " storage and " +
                                std::to_string(table.loss.size()) + " loss moduli: must be as many of each");
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::string row = " in row " + std::to_string(i + 1) + " of the modulus table";
    require_positive("frequency" + row, table.frequency[i]);
    require_positive("storage modulus" + row, table.storage[i]);
    require_positive("loss modulus" + row, table.loss[i]);
    if (i > 0 && table.frequency[i] <= table.frequency[i - 1]) {
      reject("frequency" + row, table.frequency[i], "must be above that of the row before");
    }
  }
}

const std::vector<WantedColumn>& modulus_columns() {
  const Units frequency_units{{"Hz", 1}, {"hz", 1}, {"kHz", 1e3}, {"mHz", 1e-3}, {"rad/s", 1 / (2 * pi)}};
  static const std::vector<WantedColumn> wanted{
      {{{"frequency", {"f", "freq*", "fred*", "frequenz*", "omega*", "w", "\u03c9", "\u0192"}, frequency_units}}},
      {{{"storage modulus",
         {"g'", "e'", "m'", "g1", "e1", "gp", "ep", "gprime", "eprime", "gstor*", "estor*", "stor*", "shearstor*",
          "tensilestor*", "speicher*", "elasticmod*"},
         modulus_units()}}},
      {{{"loss modulus",
         {"g''", "e''", "m''", "g2", "e2", "gpp", "epp", "gdoubleprime", "edoubleprime", "gloss*", "eloss*", "loss",
          "lossmod*", "shearloss*", "tensileloss*", "verlustm*", "viscousmod*"},
         modulus_units()},
        {"loss factor", {"tan*", "lossfac*", "losstan*", "verlustf*", "damping*"}, ratio_units()}},
       false,
       true}};
  return wanted;
}

ModulusTable read_modulus_table(std::istream& stream, const std::string& source_name, double factor) {
  require_positive("factor of the moduli", factor);
  auto chosen = read_columns(stream, source_name, modulus_columns(), InOrder::yes);
  auto& csv = chosen.csv;
  const auto& wanted = modulus_columns();
  const auto unit = [&](std::size_t column, const ColumnKind& kind) {
    return unit_of_column(csv, column, kind.units, source_name);
  };
  scale(csv.columns[0], unit(0, wanted[0].kinds[0]), "frequency", csv, source_name);
  scale(csv.columns[1], unit(1, wanted[1].kinds[0]) * factor, "storage modulus", csv, source_name);
  if (has_loss_factor(chosen)) {
    scale(csv.columns[2], csv.units.empty() ? 1 : unit(2, wanted[2].kinds[1]), "loss factor", csv, source_name);
    std::transform(csv.columns[1].begin(), csv.columns[1].end(), csv.columns[2].begin(), csv.columns[2].begin(),
                   std::multiplies<>());
  } else {
    scale(csv.columns[2], unit(2, wanted[2].kinds[0]) * factor, "loss modulus", csv, source_name);
  }
  ModulusTable table = ordered(csv.columns);
  if (table.frequency.size() < 2) {
    throw std::invalid_argument(source_name + ": has a single frequency; must have at least 2");
  }
  return table;
}

bool has_loss_factor(const ChosenColumns& chosen) {
  return chosen.kind.at(2) == std::optional<std::size_t>(1);
}

std::complex<double> complex_modulus(const ModulusTable& table, double omega) {
  validate(table);
  require_positive("angular frequency", omega);
  const double lowest = table.frequency.front(), highest = table.frequency.back();
  const double wanted = omega / (2 * pi);
  if (wanted < lowest * (1 - 1e-12) || wanted > highest * (1 + 1e-12)) {
    std::ostringstream range;
    range.precision(6);
    range << "must lie in the measured range, " << lowest << " to " << highest << " Hz";
    reject("frequency in Hz", wanted, range.str());
  }
  const double frequency = std::clamp(wanted, lowest, highest);
  const auto above = std::upper_bound(table.frequency.begin() + 1, table.frequency.end() - 1, frequency);
  const std::size_t i = static_cast<std::size_t>(above - table.frequency.begin());
  // log1p keeps the weight accurate between frequencies that agree in most digits.
  const auto log_ratio = [](double a, double b) { return std::log1p((a - b) / b); };
  const double weight =
      log_ratio(frequency, table.frequency[i - 1]) / log_ratio(table.frequency[i], table.frequency[i - 1]);
  const auto between = [&](const std::vector<double>& moduli) {
    return std::exp((1 - weight) * std::log(moduli[i - 1]) + weight * std::log(moduli[i]));
  };
  return {between(table.storage), between(table.loss)};
}

}  // namespace fretval::mdr
