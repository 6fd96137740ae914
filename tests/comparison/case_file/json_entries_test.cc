#include "comparison/case_file/json_entries.h"

#include <gtest/gtest.h>

#include "comparison/case_file/case_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/refusal.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::json_entries_test {
namespace {

TEST(JsonEntries, EverythingThatIsWrongIsSaid) {
  const ScratchFolder folder;
  const auto file = folder.write("a.json", R"({"Elastomer": {"Rheology": "prony", "Branch moduli": [1e6, "-2 MPa"]},
    "Frition": {"Coefficient": 1}, "Wear": {"Cycles": null, "Speed": 1}})");
  expect_parts(
      refusal([&] { read_case_file(file); }),
      {"Elastomer / Branch moduli = 1000000.0, -2 MPa: expected a list", "a.json: subsection Frition: no such",
       "did you mean Friction?", "a.json: Wear / Cycles: must be text", "a.json: Wear / Speed: no such entry"});
}

}  // namespace
}  // namespace fretval::json_entries_test
