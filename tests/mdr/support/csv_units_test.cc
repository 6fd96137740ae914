#include "mdr/support/csv_units.h"

#include <gtest/gtest.h>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::csv_units_test {
namespace {

const std::map<std::string, double> known{{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}};

double unit(const std::vector<std::string>& names, const std::vector<std::string>& units, std::size_t column) {
  return unit_of_column({names, units, {}, {}}, column, known, "dma.csv");
}

TEST(CsvUnits, StandInTheSecondHeaderLineOrInBrackets) {
  EXPECT_EQ(unit({"a", "b"}, {"kPa", "MPa"}, 0), 1e3);
  EXPECT_EQ(unit({"a", "b"}, {"kPa", "MPa"}, 1), 1e6);
  EXPECT_EQ(unit({"a", "b"}, {"[kPa]", "(MPa)"}, 1), 1e6);
  EXPECT_EQ(unit({"a [Pa]", "b (kPa)"}, {}, 1), 1e3);
}

TEST(CsvUnits, SecondHeaderLineGoesBeforeBrackets) {
  EXPECT_EQ(unit({"a [kPa]"}, {"MPa"}, 0), 1e6);
}

TEST(CsvUnits, LastBracketsOfANameAreTheUnit) {
  EXPECT_EQ(unit({"modulus (storage) [MPa]"}, {}, 0), 1e6);
}

// Micro as the letter u, the sign of its own and the Greek letter.
TEST(CsvUnits, AreThoseThatPeopleWrite) {
  for (const char* micro : {"u", "\u00b5", "\u03bc"}) {
    EXPECT_EQ(length_units().at(std::string(micro) + "m"), 1e-6);
    EXPECT_EQ(time_units().at(std::string(micro) + "s"), 1e-6);
    EXPECT_EQ(force_units().at(std::string(micro) + "N"), 1e-6);
  }
  EXPECT_EQ(length_units().at("cm"), 1e-2);
  EXPECT_EQ(force_units().at("MN"), 1e6);
  EXPECT_EQ(modulus_units().at("N/mm^2"), 1e6);
  EXPECT_EQ(time_units().at("h"), 3600);
  EXPECT_EQ(ratio_units().at("%"), 1e-2);
}

TEST(CsvUnits, WithoutAnyAreTheBaseUnit) {
  EXPECT_EQ(unit({}, {}, 1), 1);
  EXPECT_EQ(unit({"kPa", "MPa"}, {}, 1), 1);
  EXPECT_EQ(unit({"G] [", "b"}, {}, 0), 1);
  EXPECT_EQ(unit({"a [kPa]", "b"}, {}, 1), 1);
}

TEST(CsvUnits, UnknownOnesAreNamedWithSourceColumnAndChoice) {
  EXPECT_EQ(error_of([] {
              unit({"a", "b [psi]"}, {}, 1);
            }),
            "dma.csv: unit of column 2 = \"psi\": must be one of MPa, Pa, kPa");
  EXPECT_NE(error_of([] { unit({"a"}, {"mpa"}, 0); }).find("column 1 = \"mpa\""), std::string::npos);
  EXPECT_EQ(unit({"a"}, {""}, 0), 1);
  EXPECT_FALSE(names_unit({{"a"}, {""}, {}, {}}, 0));
}

}  // namespace
}  // namespace fretval::mdr::csv_units_test
