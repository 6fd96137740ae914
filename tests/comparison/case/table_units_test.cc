#include "comparison/case/table_units.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/refusal.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::table_units_test {
namespace {

std::string said_of(const std::string& table, std::size_t n_columns) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", table).string();
  return refusal([&] { require_units(file, n_columns); });
}

TEST(TableUnits, StandInALineOfTheirOwnOrInBrackets) {
  EXPECT_EQ(said_of("r,f\nmm,um\n0,0\n", 2), "no error");
  EXPECT_EQ(said_of("r [mm],f (um)\n0,0\n", 2), "no error");
  EXPECT_EQ(said_of("f [Hz],G' [Pa],tan delta\n1,1,1\n", 3), "no error");
}

TEST(TableUnits, MustBeThereForEveryColumn) {
  expect_parts(said_of("0,0\n", 2), {"a.csv: column 1 has no unit", "\"r,f\" and \"mm,um\""});
  expect_parts(said_of("r [mm],f\n0,0\n", 2), {"column 2 has no unit"});
  expect_parts(said_of("f [Hz],G' [Pa],G''\n1,1,1\n", 3), {"column 3 has no unit", "Hz,MPa,MPa"});
  expect_parts(said_of("r,f\nmm,um\n0,x\n", 2), {"a.csv, line 3"});
}

}  // namespace
}  // namespace fretval::table_units_test
