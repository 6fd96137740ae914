#include "comparison/case_file/units.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

double value(const std::string& text, Dimension dimension) {
  return read_measure(text, dimension).value().value;
}

TEST(Units, AreConvertedToTheBaseUnitWithoutRounding) {
  EXPECT_EQ(value("20 um", Dimension::length), 20e-6);
  EXPECT_EQ(value("20 \u00b5m", Dimension::length), 20e-6);
  EXPECT_EQ(value("20 \u03bcm", Dimension::length), 20e-6);
  EXPECT_EQ(value("0.3mm", Dimension::length), 0.3e-3);
  EXPECT_EQ(value("+60 deg", Dimension::angle), 60);
  EXPECT_FALSE(read_measure("+-60 deg", Dimension::angle));
  EXPECT_EQ(value("1.5 MPa", Dimension::pressure), 1.5e6);
  EXPECT_EQ(value("2 min", Dimension::time), 120);
  EXPECT_DOUBLE_EQ(value("6.283185307179586 rad/s", Dimension::frequency), 1);
  EXPECT_DOUBLE_EQ(value("3.141592653589793 rad", Dimension::angle), 180);
  EXPECT_EQ(value("3 MPa s", Dimension::viscosity), 3e6);
  EXPECT_DOUBLE_EQ(value("293.15 K", Dimension::temperature), 20);
  EXPECT_EQ(value("51.6 K", Dimension::difference), 51.6);
  // 1 mm^3/(N m) = 1e-9 m^3/J = 1e-9/Pa
  EXPECT_DOUBLE_EQ(value("2e-5 mm^3/(N m)", Dimension::wear_rate), 2e-14);
}

TEST(Units, AreSiWithoutOne) {
  const auto plain = read_measure("1e-3", Dimension::length);
  EXPECT_EQ(plain->value, 1e-3);
  EXPECT_FALSE(plain->has_unit);
  EXPECT_TRUE(read_measure("1 m", Dimension::length)->has_unit);
  EXPECT_EQ(value("7", Dimension::varying), 7);
}

// One table of units: what a column of a table may be in, an entry may, and the other way round.
TEST(Units, OfTablesAndOfEntriesAreTheSame) {
  const std::vector<std::pair<Dimension, const std::map<std::string, double>*>> both{
      {Dimension::length, &mdr::length_units()},
      {Dimension::pressure, &mdr::modulus_units()},
      {Dimension::time, &mdr::time_units()},
      {Dimension::force, &mdr::force_units()}};
  for (const auto& [dimension, sizes] : both) {
    for (const auto& [name, size] : *sizes) {
      const auto read = read_measure("1 " + name, dimension);
      ASSERT_TRUE(read) << name;
      EXPECT_DOUBLE_EQ(read->value, size) << name;
    }
    std::istringstream names(base_unit(dimension) + ", " + other_units(dimension));
    for (std::string name; std::getline(names >> std::ws, name, ',');) EXPECT_EQ(sizes->count(name), 1U) << name;
  }
}

TEST(Units, OfSomethingElseAreRefused) {
  for (const char* text : {"5 Hz", "5 MM", "5 mm mm", "mm", "", "5,0 mm", "nan", "1e999 mm"})
    EXPECT_FALSE(read_measure(text, Dimension::length)) << text;
  EXPECT_FALSE(read_measure("5 m", Dimension::number));
  EXPECT_FALSE(read_measure("5 m", Dimension::varying));
}

TEST(Units, AreNamedInMessages) {
  EXPECT_EQ(valid_units(Dimension::force), "in N, kN, MN, mN, uN, \u00b5N, nN; in N without a unit");
  EXPECT_EQ(valid_units(Dimension::number), "a pure number, without a unit");
  EXPECT_EQ(base_unit(Dimension::wear_rate), "1/Pa");
}

}  // namespace
}  // namespace fretval
