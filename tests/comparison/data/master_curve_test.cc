#include "comparison/data/master_curve.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>

#include "mdr/rheology/prony_body.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

struct Fitted {
  Case::Elastomer elastomer;
  std::string warnings;
};

Fitted fit_of(const std::string& table, bool youngs = false) {
  const ScratchFolder folder;
  const auto file = folder.write("dma.csv", table).string();
  Fitted fitted;
  std::vector<std::string> warnings;
  fit_master_curve(file, youngs, fitted.elastomer, warnings);
  for (const auto& warning : warnings) {
    expect_parts(warning, {file + ": "});
    fitted.warnings += warning;
  }
  return fitted;
}

std::string with_marks(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

/// Rows of f;E';E'' as E'';T;f;E'.
std::string reordered(const std::string& rows) {
  std::istringstream lines(rows);
  std::string text, frequency, storage, loss;
  while (std::getline(lines, frequency, ';') && std::getline(lines, storage, ';') && std::getline(lines, loss))
    text += fmt::format("{};20,5;{};{}\r\n", loss, frequency, storage);
  return text;
}

TEST(MasterCurve, OfAStandardSolidIsThatBody) {
  const auto [shear, warnings] = fit_of(standard_solid_table());
  EXPECT_EQ(warnings, "");
  EXPECT_NEAR(shear.relaxed_modulus / 1e6, 1, 1e-2);
  const auto& moduli = shear.branch_moduli;
  EXPECT_NEAR(std::accumulate(moduli.begin(), moduli.end(), 0.0) / 1e6, 1, 2e-2);
  EXPECT_EQ(shear.master_curve->frequency.size(), 81U);
  EXPECT_NEAR(fit_of(standard_solid_table(), true).elastomer.relaxed_modulus, shear.relaxed_modulus / 3, 1);
}

/// Young's moduli of 27 branches over 26 decades with noise of 1.5 %: rows of f in Hz, E', E'' in MPa.
std::string wide_rows(const mdr::PronyBody& body, const char* separator) {
  std::mt19937 engine(7);
  std::normal_distribution<double> scatter(0, 0.015);
  std::string rows;
  for (int k = 0; k <= 26 * 6; ++k) {
    const double frequency = std::pow(10, -13 + k / 6.0);
    const auto modulus = mdr::complex_modulus(body, 2 * M_PI * frequency);
    rows += fmt::format("{:.6e}{sep}{:.6e}{sep}{:.6e}\n", frequency, 3e-6 * modulus.real() * (1 + scatter(engine)),
                        3e-6 * modulus.imag() * (1 + scatter(engine)), fmt::arg("sep", separator));
  }
  return rows;
}

// The round trip: a known body, sampled, exported in several dialects and read back.
TEST(MasterCurve, OfAnyDialectIsTheBodyThatWasSampled) {
  mdr::PronyBody body{1e6, {}, {}, 0};
  for (int k = -13; k <= 13; ++k) {
    body.branch_moduli.push_back(3e5 * (1 + 0.5 * std::sin(k)));
    body.branch_times.push_back(std::pow(10, k));
  }
  const std::string plain = "f,E',E''\nHz,MPa,MPa\n" + wide_rows(body, ","), points = wide_rows(body, ";");
  const auto reference = fit_of(plain, true);
  for (const auto& text :
       {"Instrument;DMA\r\nE'' [MPa];T [\xB0\x43];f [Hz];E' [MPa]\r\n" + reordered(with_marks(points, '.', ',')),
        "\xEF\xBB\xBF" + with_marks("f;E_stor;E_loss\nHz;MPa;MPa\n" + with_marks(points, '.', ','), ';', '\t')}) {
    const auto fitted = fit_of(text, true).elastomer;
    EXPECT_EQ(fitted.branch_moduli, reference.elastomer.branch_moduli) << text.substr(0, 60);
    EXPECT_EQ(fitted.relaxed_modulus, reference.elastomer.relaxed_modulus);
  }
  const auto& fitted = reference.elastomer;
  for (int k = -12; k <= 12; ++k) {
    const double omega = 2 * M_PI * std::pow(10, k);
    const auto read =
        mdr::complex_modulus(mdr::prony(fitted.relaxed_modulus, fitted.branch_moduli, fitted.branch_times), omega);
    EXPECT_LT(std::abs(read / mdr::complex_modulus(body, omega) - 1.0), 0.015) << omega;
  }
}

// Moduli that no body has are used all the same.
TEST(MasterCurve, WarnsAboutModuliThatContradictEachOther) {
  expect_parts(fit_of(standard_solid_table(4)).warnings, {"Kramers and Kronig", "the Prony body misses the moduli by"});
}

TEST(MasterCurve, OfFewFrequenciesIsFittedButNotHeldToItself) {
  const auto [elastomer, warnings] = fit_of(
      "f, G', tan delta\nHz, MPa, 1\n0.01, 0.62, 0.05\n0.1, 0.68, 0.07\n1, 0.77, 0.11\n10, 0.93, 0.17\n100, 1.25, "
      "0.28\n");
  expect_parts(warnings, {"Kramers and Kronig", "5 frequencies, must be at least 8"});
  EXPECT_FALSE(elastomer.master_curve->kramers_kronig);
  EXPECT_LT(elastomer.master_curve->residual, 0.1);
}

// A spring-pot beside a spring of 1 MPa: G = 1 + c (i f)^0.3, whose loss at the lowest frequency is far from none. The
// storage modulus falls below by (2/pi) G''/0.3 (c f^0.3 cos(0.15 pi) altogether).
TEST(MasterCurve, WarnsAboutARelaxedModulusThatIsExtrapolated) {
  std::string table = "f,G',G''\nHz,MPa,MPa\n";
  const double pi = std::acos(-1.0);
  for (int k = 0; k <= 24; ++k) {
    const double f = std::pow(10, -2 + k / 6.0), size = 2 * std::pow(f, 0.3);
    table += fmt::format("{:.8g},{:.8g},{:.8g}\n", f, 1 + size * std::cos(0.15 * pi), size * std::sin(0.15 * pi));
  }
  const auto [elastomer, warnings] = fit_of(table);
  expect_parts(warnings, {"at the lowest frequency, 0.01 Hz, tan delta is still 0.16", "is extrapolated"});
  const auto range = extrapolated_range(*elastomer.master_curve, elastomer.relaxed_modulus);
  ASSERT_TRUE(range);
  EXPECT_LT(range->least, 1e6 * 1.02);
  EXPECT_GT(range->least, 1e6 * 0.9);
  EXPECT_NEAR(range->most, 1e6 * (1 + 2 * std::pow(0.01, 0.3) * std::cos(0.15 * pi)), 1e2);
  EXPECT_FALSE(extrapolated_range(*fit_of(standard_solid_table()).elastomer.master_curve, 1e6));
}

TEST(MasterCurve, RefusesATableByItsName) {
  expect_parts(refusal([] { fit_of("1,1e6,1e5\n2,1e6,1e5\n"); }), {"dma.csv: "});
}

// The slope of the loss is that of a decade, whatever the first rows scatter: of f^(1/2) from 1 to 16 Hz, so that
// G'(0) is 2/pi of G'' over 1/2 below.
TEST(MasterCurve, TakesTheSlopeOfTheLossFromADecade) {
  Case::MasterCurve data;
  data.frequency = {1, 2, 4, 8, 16, 32};
  data.storage = {1e6, 1.1e6, 1.2e6, 1.3e6, 1.4e6, 1.5e6};
  data.loss = {2e5, 4e5, 8e5, 8e5, 8e5, 8e5};
  const auto range = extrapolated_range(data, 0.95e6);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->least, 1e6 - 2 / M_PI * 2e5 / 0.5, 1);
}

TEST(MasterCurve, SaysInPercentHowMuchItsModuliContradictEachOther) {
  const auto [elastomer, warnings] = fit_of(standard_solid_table(2));
  const double worst = elastomer.master_curve->kramers_kronig.value().worst;
  EXPECT_GT(std::abs(worst), 0.1);
  expect_parts(warnings, {fmt::format("Hz by {:.0f} %; no linear viscoelastic body", 100 * worst)});
}

}  // namespace
}  // namespace fretval
