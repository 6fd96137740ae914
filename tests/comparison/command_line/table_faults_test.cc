#include <gtest/gtest.h>

#include "comparison/case_file/case_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/refusal.h"

namespace fretval::table_faults_test {
namespace {

struct BadTable {
  std::string text;
  std::vector<std::string> message;
};

TEST(TableFaults, BadProfilesAreRefusedByFileAndLine) {
  const std::string rows = "r,f\nm,m\n0,0\n1e-4,1e-6\n2e-4,4e-6\n3e-4,9e-6\n";
  const std::vector<BadTable> bad{{"", {"no rows"}},
                                  {rows + "4e-4\n", {"line 7", "has 1 value; must have one in column 2"}},
                                  {rows + "4e-4;1,6e-5\n", {"line 7", "semicolons", "rows before have commas"}},
                                  {rows + "2e-4,4e-6\n", {"line 7", "radius = 0.0002", "scan outwards"}},
                                  {rows + "-4e-4,1\n", {"line 7", "radius = -0.0004"}},
                                  {rows + "4e-4,nan\n", {"line 7", "finite"}},
                                  {rows + std::string("\0\1\2", 3), {"line 7", "zero byte"}},
                                  {"r,f\nm,m\n0,0\n1e-4,1e-6\n", {"at least 4"}},
                                  {"0,0\n1,1\n2,4\n3,9\n", {"column 1 has no unit", "mm,um"}},
                                  {"r [mm],f\n0,0\n1,1\n2,4\n3,9\n", {"column 2 has no unit"}},
                                  {rows + std::string(1'000'000, '1'), {"line 7", "10000 characters"}}};
  for (const auto& [text, parts] : bad) {
    const ScratchFolder folder;
    folder.write("pin.csv", text);
    const auto file =
        folder.write("bad.prm", replace(replace(valid_case, "parabola", "table"), "Radius = 1e-2", "Table = pin.csv"));
    const auto message = refusal([&] { prepare(read_case_file(file)); });
    expect_parts(message, {"pin.csv"});
    expect_parts(message, parts);
  }
}

TEST(TableFaults, BadModuliAreRefusedByFileAndLine) {
  const std::string units = "f,G',G''\nHz,Pa,Pa\n";
  const std::vector<BadTable> bad{{units + "1,1e6,1e5\n", {"single frequency", "at least 2"}},
                                  {units + "1,1e6,1e5\n2,-1e6,1e5\n", {"line 4", "storage modulus", "positive"}},
                                  {units + "1,1e6,1e5\n0,1e6,1e5\n", {"line 4", "frequency", "positive"}},
                                  {"1,1e6\n2,1e6\n", {"line 1", "must have 3"}},
                                  {"1,1e6,1e5\n2,1e6,1e5\n", {"column 1 has no unit", "Hz,MPa,MPa"}},
                                  {"f,G',G''\nHz,bar,bar\n1,1,1\n2,1,1\n", {"bar", "Pa"}}};
  for (const auto& [text, parts] : bad) {
    const ScratchFolder folder;
    folder.write("dma.csv", text);
    const auto file = folder.write("bad.prm", case_with_modulus_table());
    const auto message = refusal([&] { prepare(read_case_file(file)); });
    expect_parts(message, {"dma.csv"});
    expect_parts(message, parts);
  }
}

}  // namespace
}  // namespace fretval::table_faults_test
