#include "mdr/rheology/kramers_kronig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mdr/support/constants.h"
#include "tests/mdr/synthetic_table.h"

namespace fretval::mdr::kramers_kronig_test {
namespace {

const Rheology three_branches = prony(1e6, {2e6, 5e6, 8e6}, {3.3e-4, 0.0171, 0.71});
const Rheology one_branch = prony(1e6, {5e6}, {1e-2});
const Rheology fractional = FractionalZener{1e6, 3e7, 1e-3, 0.5};
const Rheology low_loss = FractionalZener{1e6, 3e7, 1e-3, 0.08};

double largest(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

// G' = omega^s and G'' = tan(pi s/2) G', Booij and Thoone's closed form. Error of the linear interpolation over steps
// h of a quarter of a decade: h^2/12 times the second derivative s^2 of G' over G'.
TEST(KramersKronig, PowerLawsAreConsistent) {
  const double step = std::log(10.0) / 4;
  for (const double s : {0.02, 0.2, 0.5, 0.8}) {
    ModulusTable table;
    for (int i = 0; i <= 80; ++i) {
      table.frequency.push_back(std::pow(10, -4 + 0.1 * i));
      table.storage.push_back(std::pow(table.frequency.back(), s));
      table.loss.push_back(table.storage.back() * std::tan(pi / 2 * s));
    }
    const KramersKronig result = kramers_kronig(table);
    EXPECT_TRUE(result.consistent) << s;
    EXPECT_LT(result.rms, s * s * step * step / 12) << s;
  }
}

// The header states the error of the quadrature: half of the 10 % that are allowed.
TEST(KramersKronig, ExactBodiesAreConsistent) {
  for (const Rheology& body : {three_branches, one_branch, fractional, low_loss}) {
    for (const int n_per_decade : {4, 10, 50}) {
      const KramersKronig result = kramers_kronig(synthetic_table(body, 1e-4, 1e6, n_per_decade));
      EXPECT_TRUE(result.consistent);
      EXPECT_LT(largest(result.deviation), 0.05);
      EXPECT_LE(result.rms, largest(result.deviation));
      EXPECT_EQ(result.frequency.size(), 41u);
    }
  }
}

TEST(KramersKronig, AValueADecadeIsEnough) {
  EXPECT_NO_THROW(kramers_kronig(synthetic_table(one_branch, 1e-4, 1e6, 1)));
}

// What relaxes outside the range leaves its loss in the range, but hardly a trace in G'.
TEST(KramersKronig, CutRangesAreConsistent) {
  EXPECT_TRUE(kramers_kronig(synthetic_table(one_branch, 1e-3, 1, 10)).consistent);
  EXPECT_TRUE(kramers_kronig(synthetic_table(one_branch, 300, 1e6, 10)).consistent);
  EXPECT_TRUE(kramers_kronig(synthetic_table(kelvin_voigt(1e6, 1e3), 1e-3, 1e3, 10)).consistent);
}

TEST(KramersKronig, NoiseIsAllowedFor) {
  for (const Rheology& body : {three_branches, one_branch, fractional, low_loss}) {
    for (const double noise : {0.02, 0.03}) {
      for (unsigned seed = 0; seed < 20; ++seed) {
        const KramersKronig result = kramers_kronig(synthetic_table(body, 1e-4, 1e6, 10, noise, seed));
        EXPECT_TRUE(result.consistent) << seed << ": " << result.worst << " at " << result.frequency_at_worst;
      }
    }
  }
}

// Guard for the noise allowance: it must follow the noise, not swallow everything.
TEST(KramersKronig, AllowanceGrowsWithTheNoise) {
  const auto middle = [](double noise) {
    return kramers_kronig(synthetic_table(fractional, 1e-4, 1e6, 10, noise)).allowed[20];
  };
  EXPECT_NEAR(middle(0), 0.1, 0.002);
  EXPECT_NEAR((middle(0.04) - 0.1) / (middle(0.02) - 0.1), 2, 0.1);  // seed and weights are the same
  EXPECT_LT(middle(0.02), 0.2);
}

TEST(KramersKronig, NamesTheStretchOfDoubledLoss) {
  for (const double noise : {0.0, 0.02}) {
    ModulusTable table = synthetic_table(fractional, 1e-4, 1e6, 10, noise);
    for (std::size_t i = 45; i < 56; ++i) table.loss[i] *= 2;
    const KramersKronig result = kramers_kronig(table);
    EXPECT_FALSE(result.consistent);
    EXPECT_NEAR(result.worst, -0.5, 0.05);  // half of the loss is missing
    EXPECT_GE(result.frequency_at_worst, table.frequency[45]);
    EXPECT_LE(result.frequency_at_worst, table.frequency[55]);
  }
}

TEST(KramersKronig, ReportsSwappedColumns) {
  for (const Rheology& body : {three_branches, one_branch, fractional, low_loss}) {
    ModulusTable table = synthetic_table(body, 1e-4, 1e6, 10, 0.02);
    std::swap(table.storage, table.loss);
    EXPECT_FALSE(kramers_kronig(table).consistent);
  }
}

TEST(KramersKronig, ReportsALossInAnotherUnit) {
  for (const double factor : {0.5, 2.0, 1e3}) {
    ModulusTable table = synthetic_table(fractional, 1e-4, 1e6, 10, 0.02);
    for (double& loss : table.loss) loss *= factor;
    EXPECT_FALSE(kramers_kronig(table).consistent) << factor;
  }
}

// Overlapping pieces of a master curve bring frequencies that agree but for roundoff, with moduli that do not.
TEST(KramersKronig, TakesNearDuplicates) {
  ModulusTable table = synthetic_table(fractional, 1e-4, 1e6, 10, 0.02);
  table.frequency[31] = std::nextafter(table.frequency[30], 1);
  table.storage[31] = 1.05 * table.storage[30];
  table.loss[31] = 1.05 * table.loss[30];
  const KramersKronig result = kramers_kronig(table);
  EXPECT_TRUE(result.consistent) << result.worst << " at " << result.frequency_at_worst;
}

TEST(KramersKronig, SaysWhatItCannotJudge) {
  const auto reason = [](const ModulusTable& table) { return too_sparse_for_kramers_kronig(table); };
  EXPECT_EQ(reason(synthetic_table(fractional, 1, 1e3, 2)), "7 frequencies, must be at least 8");
  EXPECT_EQ(reason(synthetic_table(fractional, 1, 5, 20)), "frequencies from 1 to 5 Hz, must be at least a decade");
  EXPECT_EQ(reason(synthetic_table(fractional, 1, 10, 20)), "");
  ModulusTable table = synthetic_table(fractional, 1, 1e5, 10);
  for (auto* column : {&table.frequency, &table.storage, &table.loss}) {
    column->erase(column->begin() + 11, column->begin() + 25);
  }
  EXPECT_NE(reason(table).find("none between 10 and 316"), std::string::npos) << reason(table);
  EXPECT_THROW(kramers_kronig(table), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::kramers_kronig_test
