#include "comparison/results/moduli_files.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "comparison/results/results_folder.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

TEST(ModuliFiles, HaveTheBodyAroundItsFrequenciesAndWhatWasMeasured) {
  const ScratchFolder folder;
  auto input = read_case();
  auto& curve = input.elastomer.master_curve.emplace();
  curve.frequency = {0.01, 1, 100};
  curve.storage = {1e6, 1.3e6, 2e6};
  curve.loss = {1e4, 5e5, 1e4};
  write_moduli(input, mdr::standard_solid(1e6, 1e6, 0.1), folder.path());
  const auto [f, storage] = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G' [Pa]");
  EXPECT_NEAR(f.front(), 1e-3, 1e-12);
  EXPECT_NEAR(f.back(), 1e3, 1e-6);
  EXPECT_NEAR(storage.front() / 1e6, 1, 1e-6);
  EXPECT_NEAR(storage.back() / 2e6, 1, 2e-6);
  const auto loss = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G'' [Pa]").second;
  EXPECT_NEAR(*std::max_element(loss.begin(), loss.end()), 0.5e6, 0.005e6);  // G1/2, at omega tau = 1
  const auto [at, measured] = read_columns(folder.path() / "measured_moduli.csv", "f [Hz]", "G'' [Pa]");
  EXPECT_EQ(at, (std::vector<double>{0.01, 1, 100}));
  EXPECT_EQ(measured, (std::vector<double>{1e4, 5e5, 1e4}));
}

// The valid case oscillates at 1 Hz; the moduli of spring and dashpot are equal at G0/(2 pi eta) = 15.9 Hz.
TEST(ModuliFiles, ReachADecadeBeyondTheFrequencyOfADashpot) {
  const ScratchFolder folder;
  write_moduli(read_case(), mdr::prony(1e6, {}, {}, 1e4), folder.path());
  const auto [f, loss] = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G'' [Pa]");
  EXPECT_NEAR(f.front(), 0.1, 1e-9);
  EXPECT_NEAR(f.back(), 10 * 15.915494309, 1e-6);
  EXPECT_NEAR(loss.back() / 1e7, 1, 1e-8) << "a decade beyond, ten times G0";
}

TEST(ModuliFiles, OfAnElasticBodyAreNone) {
  const ScratchFolder folder;
  write_moduli(read_case(elastic_case()), mdr::elastic(1e6), folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "moduli.csv"));
}

}  // namespace
}  // namespace fretval
