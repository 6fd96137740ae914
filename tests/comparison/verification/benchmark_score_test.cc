#include "comparison/verification/benchmark_score.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

std::map<Quantity, double> answer(const std::string& table) {
  std::istringstream stream(table);
  return read_foreign_answer(stream, "mine.csv");
}

// The published radii of 10-elastic-60-degrees: 1.09545, 0.808449 and 0.852523 mm.
TEST(BenchmarkScore, HoldsNumbersToABenchmark) {
  const auto rows = benchmark_score(
      "10-elastic-60-degrees",
      answer("# of my code\ncontact_radius_max,stick_radius_shakedown,normal_force_max\nmm,um,mN\n1.0954,851,790\n"),
      1e-2);
  std::map<Quantity, ScoreRow> by_quantity;
  for (const auto& row : rows) by_quantity.emplace(row.quantity, row);
  const auto& contact = by_quantity.at(Quantity::contact_radius_max);
  EXPECT_TRUE(contact.agrees);
  EXPECT_NEAR(contact.difference.value(), (1.0954 - 1.09545) / 1.09545, 2e-6);
  const auto& stick = by_quantity.at(Quantity::stick_radius_shakedown);
  EXPECT_TRUE(stick.agrees);
  EXPECT_NEAR(stick.difference.value(), (0.851 - 0.852515) / 1.09545, 2e-6);
  EXPECT_FALSE(by_quantity.at(Quantity::normal_force_max).agrees) << "701 mN";
  EXPECT_FALSE(by_quantity.at(Quantity::stick_radius_first_slip).value) << "not given";
  expect_parts(score_text("10-elastic-60-degrees", rows, 1e-2), {"2 of 3 quantities agree within 0.01", "DISAGREES"});
  expect_parts(score_text("10-elastic-60-degrees", rows, 1e-2), {fmt::format("; {} not given", rows.size() - 3)});
  EXPECT_EQ(score_json("x", rows, 1e-2).at("quantities").at("normal_force_max").at("agrees"), false);
}

TEST(BenchmarkScore, TakesEnergiesInAnyUnit) {
  for (const std::string table : {"2e-6\nJ", "0.002\nmJ", "2\nuJ", "2\n\u00b5J", "2000\nnJ"}) {
    const auto end = table.find('\n');
    const auto values = answer("cycle_work\n" + table.substr(end + 1) + "\n" + table.substr(0, end) + "\n");
    EXPECT_NEAR(values.at(Quantity::cycle_work), 2e-6, 1e-18) << table;
  }
}

// A code that steps through time finds the shakedown radius, and may take it for the other one.
TEST(BenchmarkScore, SaysThatARadiusIsTheOtherOne) {
  for (const auto& row :
       benchmark_score("10-elastic-60-degrees", answer("stick_radius_first_slip\nmm\n0.8525\n"), 1e-2))
    if (row.quantity == Quantity::stick_radius_first_slip) {
      EXPECT_EQ(row.remark, "is the stick radius, shakedown");
    }
  for (const auto& row : benchmark_score("16-no-first-slip-zone", answer("stick_radius_first_slip\nmm\n0.1\n"), 1e-2))
    if (row.quantity == Quantity::stick_radius_first_slip) {
      EXPECT_FALSE(row.agrees);
      EXPECT_EQ(row.remark, "there is none");
    }
}

TEST(BenchmarkScore, RefusesWhatIsNoAnswer) {
  const auto said = [](const std::string& table) { return refusal([&] { answer(table); }); };
  expect_parts(said("contact_radius,x\nmm,mm\n1,2\n"),
               {"mine.csv: column contact_radius", "no such quantity", "stick_radius_shakedown"});
  expect_parts(said("contact_radius_max\n1\n"), {"column contact_radius_max has no unit"});
  expect_parts(said("contact_radius_max\nN\n1\n"), {"must be one of", "mm"});
  expect_parts(said("1\n"), {"has no names"});
  expect_parts(said("# nothing\n"), {"is empty"});
  expect_parts(said("contact_radius_max\nmm\n1\n2\n"), {"has 2 rows of numbers"});
  expect_parts(refusal([] { benchmark_score("01-hert", answer("contact_radius_max\nmm\n1\n"), 0.1); }),
               {"--benchmark 01-hert", "did you mean 01-hertz?", "22-wear-to-the-limit"});
  EXPECT_EQ(benchmark_names().size(), 22U);
}

}  // namespace
}  // namespace fretval
