#include "comparison/case/table_units.h"

#include <fmt/format.h>

#include <fstream>

#include "comparison/case/case.h"
#include "mdr/rheology/modulus_table.h"
#include "mdr/support/csv_units.h"

namespace fretval {

void require_units(const std::string& file, std::size_t n_columns) {
  const char* const example = n_columns == 2 ? "\"r,f\" and \"mm,um\"" : "\"f,G',G''\" and \"Hz,MPa,MPa\"";
  try {
    std::ifstream stream(file);
    const auto csv = mdr::read_csv(stream, file, n_columns);
    for (std::size_t column = 0; column < n_columns; ++column)
      if (!names_unit(csv, column) && !(column == 2 && mdr::has_loss_factor(csv)))
        throw InputError(
            fmt::format("{}: column {} has no unit; must begin with a line of names and one of units, for example {}",
                        file, column + 1, example));
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

}  // namespace fretval
