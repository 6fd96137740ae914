#include "comparison/accuracy/prepared_case.h"

#include <fmt/format.h>

#include <set>
#include <string>

#include "comparison/case/plausibility.h"

namespace fretval {

std::vector<PreparedCase> prepare(const std::vector<Case>& cases) {
  std::vector<PreparedCase> prepared;
  std::set<std::string> names;
  for (const auto& input : cases) {
    if (!names.insert(input.name).second)
      throw InputError(
          fmt::format("{}: a case named {} is already there; case files need different names", input.file, input.name));
    try {
      const auto mdr = mdr_case(input);
      prepared.push_back({input, mdr, fem_case(input, expected_contact(mdr), limiting_indenter(mdr)),
                          tolerances_of(input.tolerance, input.cycle_tolerance)});
      for (auto& warning : implausible_values(input, mdr.profile))
        prepared.back().input.warnings.push_back(std::move(warning));
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {}", input.file, error.what()));
    }
  }
  return prepared;
}

}  // namespace fretval
