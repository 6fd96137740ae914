#include "comparison/data/table_units.h"

#include <gtest/gtest.h>

#include "mdr/profiles/profile_csv.h"
#include "mdr/rheology/modulus_table.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::table_units_test {
namespace {

const auto& profile = mdr::profile_columns();
const auto& moduli = mdr::modulus_columns();

std::string said_of(const std::string& table, const std::vector<mdr::WantedColumn>& wanted) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", table).string();
  return refusal([&] { require_units(file, wanted); });
}

TEST(TableUnits, StandInALineOfTheirOwnOrInBrackets) {
  EXPECT_EQ(said_of("r,f\nmm,um\n0,0\n", profile), "no error");
  EXPECT_EQ(said_of("r [mm],f (um)\n0,0\n", profile), "no error");
  EXPECT_EQ(said_of("f [Hz],G' [Pa],tan delta\n1,1,1\n", moduli), "no error");
}

TEST(TableUnits, MustBeThereForEveryColumn) {
  expect_parts(said_of("0,0\n", profile), {"a.csv: column 1 has no unit", "\"r,f\" and \"mm,um\""});
  expect_parts(said_of("r [mm],f\n0,0\n", profile), {"column 2 has no unit"});
  expect_parts(said_of("f [Hz],G' [Pa],G''\n1,1,1\n", moduli), {"column 3 has no unit", "Hz,MPa,MPa"});
  expect_parts(said_of("r,f\nmm,um\n0,x\n", profile), {"a.csv, line 3"});
}

TEST(TableUnits, ComeWithWhatIsSkipped) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", "made by hand\nT;r [mm];f [um]\n1;0;0\n").string();
  EXPECT_EQ(require_units(file, profile), file + ": skipped: 1 line ahead of the columns, column T");
  EXPECT_EQ(require_units(folder.write("b.csv", "r,f\nmm,um\n0,0\n").string(), profile), "");
}

}  // namespace
}  // namespace fretval::table_units_test
