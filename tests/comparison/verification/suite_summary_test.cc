#include "comparison/verification/suite_summary.h"

#include <gtest/gtest.h>

#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(QuantitySummary, IsByQuantityAndTolerance) {
  auto other = row_of(1e-3, 2e-3);
  other.compared[Quantity::normal_force_max] = {1, 1, 1e-3, 1e-4, "rings"};
  other.compared[Quantity::stick_radius_shakedown].tolerance = 1e-4;
  const auto all = quantity_summaries({row_of(1e-3, 2e-3), row_of(-4e-3, 2e-3), row_of(2e-3, infinity),
                                       row_of(not_a_number, 3e-2), row_of(0, 2e-3), other});
  ASSERT_EQ(all.size(), 3U);
  const auto& force = all.at({Quantity::normal_force_max, 1e-3});
  EXPECT_EQ(force.errors, std::vector<double>{0});
  EXPECT_TRUE(force.effectivities.empty()) << "of an error that is zero";
  EXPECT_EQ(all.at({Quantity::stick_radius_shakedown, 1e-4}).n_wide, 1U);
  const auto& usual = all.at({Quantity::stick_radius_shakedown, 1e-2});
  EXPECT_EQ(usual.n, 5U);
  EXPECT_EQ(usual.n_above, 2U);
  EXPECT_EQ(usual.n_wide, 2U);
  EXPECT_EQ(usual.errors.size(), 4U);
  EXPECT_EQ(usual.bars, (std::vector<double>{2e-3, 2e-3, 2e-3}));
  ASSERT_EQ(usual.effectivities.size(), 2U);
  EXPECT_NEAR(usual.effectivities[0], 2, 1e-12);
  EXPECT_NEAR(usual.effectivities[1], 0.5, 1e-12);
}

TEST(ShownRows, AreAllOfASmallSuite) {
  const std::vector<SuiteRow> rows{row_of(1e-3, 2e-3), row_of(3e-2, 2e-3)};
  ASSERT_EQ(shown_rows(rows).size(), 2U);
  EXPECT_EQ(shown_rows(rows)[0], &rows[0]);
}

TEST(ShownRows, AreTheWorstOfALargeOne) {
  std::vector<SuiteRow> rows(300, row_of(1e-3, 2e-3));
  rows[250] = row_of(1.9e-3, 2e-3);
  EXPECT_EQ(shown_rows(rows).size(), 10U);
  EXPECT_EQ(shown_rows(rows)[0], &rows[250]);
  for (std::size_t k = 100; k < 120; ++k) rows[k] = row_of(3e-3, 2e-3);
  rows[299].failure = "singular";
  ASSERT_EQ(shown_rows(rows).size(), 21U) << "every one that fails";
  EXPECT_EQ(shown_rows(rows).back(), &rows[299]);
}

TEST(WorstQuantity, IsTheClosestToItsBar) {
  EXPECT_EQ(worst_of(SuiteRow{}), nullptr);
  auto row = row_of(1e-3, 2e-3);
  row.compared[Quantity::contact_radius_max] = {1, 1.003, 1e-3, 4e-3, "rings"};
  EXPECT_EQ(worst_of(row)->first, Quantity::contact_radius_max);
  row.compared[Quantity::stick_radius_first_slip] = {0.5, not_a_number, 1e-2, 1e-3, "rings"};
  EXPECT_EQ(worst_of(row)->first, Quantity::stick_radius_first_slip);
}

TEST(Remark, SaysWhyARowFailsIsRefusedOrIsInconclusive) {
  EXPECT_EQ(remark_of(row_of(1e-3, 2e-3)), "");
  EXPECT_EQ(remark_of(refused_row("a", "a b")), "a b");
  EXPECT_EQ(remark_of(refused_row("", "a b")), "refused: a b");
  EXPECT_EQ(remark_of(row_of(1e-3, 2e-2)), "stick radius, shakedown: bar 2.0e-02, mostly rings, tolerance 1e-02");
}

}  // namespace
}  // namespace fretval
