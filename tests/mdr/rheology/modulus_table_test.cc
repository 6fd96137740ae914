#include "mdr/rheology/modulus_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "mdr/rheology/fractional_zener.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"
#include "tests/mdr/synthetic_table.h"
#include "tests/worse.h"

namespace fretval::mdr::modulus_table_test {
namespace {

ModulusTable read(const std::string& text, double factor = 1) {
  std::istringstream stream(text);
  return read_modulus_table(stream, "dma.csv", factor);
}

using Column = std::vector<double>;

TEST(ModulusTable, ConvertsNamedUnits) {
  for (const std::string header :
       {"f,G',G''\nHz, MPa, kPa\n", "f [Hz]; G' [MPa]; G'' (kPa)\n", "f,G',G''\n[Hz],[MPa],[kPa]\n"}) {
    const ModulusTable table = read(header + "1 2 3\n4 5 6\n");
    EXPECT_EQ(table.frequency, (Column{1, 4})) << header;
    EXPECT_EQ(table.storage, (Column{2e6, 5e6}));
    EXPECT_EQ(table.loss, (Column{3e3, 6e3}));
  }
  EXPECT_DOUBLE_EQ(read("w,G',G''\nrad/s,Pa,GPa\n1,2,3\n2,2,3\n").frequency[1], 1 / pi);
}

TEST(ModulusTable, TakesPascalAndAppliesTheFactor) {
  EXPECT_EQ(read("1,6,3\n2,9,3\n").storage, (Column{6, 9}));
  EXPECT_EQ(read("f,a,b\n1,6,3\n2,9,3\n", 0.5).storage, (Column{3, 4.5}));
  EXPECT_EQ(read("f,a,b\nHz,kPa,kPa\n1,6,3\n2,9,3\n", 0.5).loss, (Column{1500, 1500}));
}

TEST(ModulusTable, TakesALossFactorForTheLossModulus) {
  for (const std::string header : {"f,G',tan delta\nHz,MPa,-\n", "f, G', tan delta\nHz, MPa, 1\n",
                                   "f [Hz],G' [MPa],Tan(d)\n", "f,G',tan d\nHz,MPa,\n"}) {
    const ModulusTable table = read(header + "1,2,0.5\n2,4,0.25\n", 0.5);
    EXPECT_EQ(table.storage, (Column{1e6, 2e6})) << header;
    EXPECT_EQ(table.loss, (Column{0.5e6, 0.5e6})) << header;
  }
  EXPECT_DOUBLE_EQ(read("f,G',tan delta [%]\n1,2,50\n2,4,25\n").loss[0], 1);
  EXPECT_DOUBLE_EQ(read("f,G',tan delta\nHz,Pa,%\n1,2,50\n2,4,25\n").loss[0], 1);
  EXPECT_NE(error_of([] { read("f,G',tan delta\nHz,Pa,Pa\n1,2,3\n"); }).find("unit of column 3 = \"Pa\""),
            std::string::npos);
}

TEST(ModulusTable, SortsAndAveragesDuplicates) {
  const ModulusTable table = read("3,30,1\n1,10,4\n3,36,2\n2,20,5\n3,24,6\n");
  EXPECT_EQ(table.frequency, (Column{1, 2, 3}));
  EXPECT_EQ(table.storage, (Column{10, 20, 30}));
  EXPECT_EQ(table.loss, (Column{4, 5, 3}));
}

TEST(ModulusTable, ErrorsOfTheFileNameTheirPlace) {
  const struct {
    const char* text;
    const char* named;
  } tables[] = {
      {"1,2,3\n2,-5,3\n", "dma.csv, line 2: storage modulus = -5: must be finite and positive"},
      {"1,2,3\n2,5,0\n", "dma.csv, line 2: loss modulus = 0"},
      {"0,2,3\n2,5,1\n", "dma.csv, line 1: frequency = 0"},
      {"f,a,b\nHz,GPa,GPa\n1,2,3\n2,1e300,3\n", "line 4: storage modulus = inf"},
      {"f,G',b\nHz,psi,Pa\n1,2,3\n", "unit of column 2 = \"psi\": must be one of GPa, MPa, N/mm^2"},
      {"f,a,b\nHz,psi,Pa\n1,2,3\n", "no column for the storage modulus"},
      {"f,a,b (psi)\n1,2,3\n", "its columns are f, a, b (psi)"},
      {"f,a,b\nHz,,Pa\n1,2,3\n", "its columns are f [Hz], a, b [Pa]"},
      {"1,2,3\n1,2,3\n", "has a single frequency"},
  };
  for (const auto& table : tables) {
    const std::string error = error_of([&] { read(table.text); });
    EXPECT_NE(error.find(table.named), std::string::npos) << error;
  }
  EXPECT_THROW(read("1,2,3\n2,2,3\n", 0), std::invalid_argument);
}

// log G is linear in log omega for a power law, so only roundoff is left.
TEST(ModulusTable, InterpolationIsExactForPowerLaws) {
  ModulusTable table;
  for (const double f : {1e-3, 2e-3, 0.7, 0.7 * (1 + 4e-16), 40.0, 1e6}) {
    table.frequency.push_back(f);
    table.storage.push_back(3e6 * std::pow(f, 0.3));
    table.loss.push_back(2e5 * std::pow(f, -0.1));
  }
  for (const double f : {1e-3, 1.3e-3, 0.1, 0.7, 5.0, 999.0, 1e6}) {
    const std::complex<double> modulus = complex_modulus(table, 2 * pi * f);
    EXPECT_NEAR(modulus.real() / (3e6 * std::pow(f, 0.3)), 1, 1e-14);
    EXPECT_NEAR(modulus.imag() / (2e5 * std::pow(f, -0.1)), 1, 1e-14);
  }
}

TEST(ModulusTable, InterpolationConvergesQuadratically) {
  const FractionalZener body{1e6, 3e7, 1e-2, 0.5};
  const auto error = [&](int n_per_decade) {
    const ModulusTable table = synthetic_table(body, 1, 1e4, n_per_decade);
    double worst = 0;
    for (const double f : log_spaced(1, 1e4, 200)) {
      const std::complex<double> exact = complex_modulus(body, 2 * pi * f);
      worst = worse(worst, std::abs(complex_modulus(table, 2 * pi * f) - exact) / std::abs(exact));
    }
    return worst;
  };
  EXPECT_NEAR(error(5) / error(10), 4, 0.4);  // next order in the spacing
}

TEST(ModulusTable, RefusesToExtrapolate) {
  const ModulusTable table{{0.5, 8}, {1, 2}, {1, 2}};
  for (const double f : {0.49, 8.01}) {
    const std::string error = error_of([&] { complex_modulus(table, 2 * pi * f); });
    EXPECT_NE(error.find("measured range, 0.5 to 8 Hz"), std::string::npos) << error;
  }
  EXPECT_NO_THROW(complex_modulus(table, 2 * pi * 8 * (1 + 1e-15)));
  EXPECT_THROW(complex_modulus(table, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(ModulusTable, ValidatesTablesMadeByHand) {
  EXPECT_NE(error_of([] { validate(ModulusTable{{1}, {1}, {1}}); }).find("at least 2"), std::string::npos);
  EXPECT_NE(error_of([] { validate(ModulusTable{{1, 2}, {1, 1}, {1}}); }).find("as many"), std::string::npos);
  EXPECT_NE(error_of([] {
              validate(ModulusTable{{1, 1}, {1, 1}, {1, 1}});
            }).find("frequency in row 2"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              validate(ModulusTable{{1, 2}, {1, 1}, {1, -1}});
            }).find("loss modulus in row 2"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::modulus_table_test
