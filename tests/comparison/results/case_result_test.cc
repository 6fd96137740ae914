#include "comparison/results/case_result.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "comparison/results/results_folder.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

// What is written comes back with the motion, and with the force that both methods say.
TEST(CaseResult, IsReadBackAsItIsWritten) {
  auto prepared = prepared_case(elastic_case());
  prepared.input.fields = Case::Fields::none;
  const auto reference = mdr_normal_response(prepared.mdr);
  BodyStore bodies;
  const auto result = result_of(prepared, reference, Proof::none, prove(prepared, Proof::none, bodies));
  const ScratchFolder folder;
  const auto place = folder.path() / "new" / "case";
  write_result(result, reference, place);
  const auto stored = read_results(folder.path()).at(0);
  EXPECT_EQ(stored.number("fe", "stick_radius_shakedown"), result.fe.fe.stick_radius_shakedown.value());
  EXPECT_EQ(stored.number("mdr", "stick_radius_shakedown"), result.mdr.stick_radius_shakedown.value());
  EXPECT_TRUE(passes(result.comparison));

  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  const auto [d, u] = read_columns(place / "history.csv", "d [m]", "u_x [m]");
  EXPECT_NEAR(largest(d), 1.2e-4, 1e-7);  // half a step of 32 off the peak
  EXPECT_NEAR(largest(u), 1.5e-5, 1e-7);
  const auto [fe, mdr] = read_columns(place / "history.csv", "F_N [N]", "F_N MDR [N]");
  ASSERT_GE(fe.size(), 16U);
  for (std::size_t k = 0; k < fe.size(); ++k) EXPECT_NEAR(fe[k], mdr[k], 5e-3 * largest(mdr)) << k;
  const auto [inner, pressure] = read_columns(place / "contact.csv", "r inner [m]", "p largest [Pa]");
  EXPECT_EQ(inner.front(), 0);
  EXPECT_EQ(largest(pressure), pressure.front());
  const auto [r, worn] = read_columns(place / "profile.csv", "r [m]", "f limiting [m]");
  EXPECT_GT(r.back(), result.mdr.worn_radius.value());
  EXPECT_FALSE(fs::exists(place / "normal_deepest.vtu"));
}

TEST(CaseResult, IsWithdrawnWithoutWhatLiesBesideIt) {
  const ScratchFolder folder;
  folder.write("result.json", "{}");
  folder.write("history.csv", "");
  withdraw_result(folder.path());
  withdraw_result(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / "result.json"));
  EXPECT_TRUE(fs::exists(folder.path() / "history.csv"));
}

}  // namespace
}  // namespace fretval
