#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

StoredResult proved(const char* proof) {
  StoredResult result{stored_result(), {}};
  result.json["proof"] = proof;
  return result;
}

StoredResult with_difference(const char* name, const nlohmann::ordered_json& difference,
                             const nlohmann::ordered_json& bar, const char* verdict) {
  StoredResult result{stored_result(), {}};
  result.json["name"] = name;
  auto& compared = result.json["comparison"]["stick_radius_shakedown"];
  compared["difference"] = difference;
  compared["error_bar"] = bar;
  compared["verdict"] = verdict;
  compared["pass"] = verdict == std::string("pass");
  return result;
}

TEST(VerdictSection, SaysWhichProofItWas) {
  const std::vector<const char*> proofs{"none", "bars", "tolerance"};
  for (const auto* proof : proofs) {
    const auto html = rendered(verdict_section({proved(proof), proved(proof)}));
    for (const auto* other : proofs)
      EXPECT_EQ(html.find(std::string("--proof ") + other) != std::string::npos, other == proof) << html;
    EXPECT_EQ(html.find("2 cases: "), std::string::npos) << "it goes without saying";
  }
  expect_parts(rendered(verdict_section({proved("none"), proved("bars"), proved("bars")})),
               {"1 case: The answer of the finite elements alone", "2 cases: The finite elements have error bars"});
}

TEST(VerdictSection, CountsCasesThatAgree) {
  auto failed = proved("bars");
  failed.json["verdict"] = "disagree";
  auto open = proved("bars"), bare = proved("none");
  open.json["verdict"] = "not resolved";
  bare.json["verdict"] = "not proved";
  expect_parts(rendered(verdict_section({proved("bars")})),
               {"badge good", "Finite elements confirm the method of dimensionality reduction (MDR): "});
  expect_parts(rendered(verdict_section({failed, proved("bars")})),
               {"badge bad", "not confirmed", "In 1 of 2 cases", "disagree: 1."});
  expect_parts(rendered(verdict_section({open, bare, proved("bars")})),
               {"badge maybe", ">not resolved<", "In 1 of 3 cases", "not resolved: 1; not proved: 1."});
  expect_parts(rendered(verdict_section({bare})), {"badge maybe", ">not proved<"});
}

TEST(VerdictSection, CountsCasesOfAnotherModelApart) {
  auto other = proved("bars");
  other.json["verdict"] = "other model";
  const auto alone = rendered(verdict_section({other, other}));
  expect_parts(alone, {"badge maybe", ">another model<", "2 cases are of another model than that of MDR"});
  EXPECT_EQ(alone.find("agrees with"), std::string::npos) << alone;
  expect_parts(rendered(verdict_section({other, proved("bars")})),
               {"badge good", "In 1 of 1 case all that was asked for agrees", "1 case is of another model"});
}

TEST(VerdictSection, OfManyBeginsWithTheValuesOfBoth) {
  auto second = proved("bars");
  second.json["name"] = "family/phase-60";
  const auto html = rendered(verdict_section({proved("bars"), second}));
  const auto values = html.find("table: the values of both methods"), differences = html.find("<h2>Differences</h2>");
  EXPECT_LT(values, differences);
  EXPECT_NE(differences, std::string::npos);
  EXPECT_EQ(rendered(verdict_section({proved("bars")})).find("Differences"), std::string::npos);
}

// The bar and the tolerance are those of the same case, not the widest of another one.
TEST(Extreme, IsTheLargestDifferenceWhateverItsSign) {
  std::vector<StoredResult> results{with_difference("small", 1e-4, 2e-4, "agree"),
                                    with_difference("large", -3e-4, 1e-4, "agree"),
                                    with_difference("wide", 2e-4, 5e-2, "not resolved")};
  constexpr auto radius = Quantity::stick_radius_shakedown;
  auto extreme = extreme_of(results, radius);
  EXPECT_EQ(extreme.size, 3e-4);
  EXPECT_EQ(extreme.name, "large");
  EXPECT_EQ(extreme.bar, 1e-4);
  EXPECT_EQ(extreme.n_compared, 3U);
  EXPECT_EQ(extreme.counts[Verdict::agree], 2U);
  EXPECT_EQ(extreme.counts[Verdict::not_resolved], 1U);
  EXPECT_EQ(extreme_of({proved("bars")}, Quantity::slip_inside_stick_zone).n_compared, 0U);
}

TEST(VerdictSection, HasARowOfNumbersForEachQuantity) {
  const auto html = rendered(
      verdict_section({with_difference("small", 1e-4, 2e-4, "agree"), with_difference("large", -3e-4, 1e-4, "agree"),
                       with_difference("wide", 2e-4, 5e-2, "not resolved")}));
  expect_parts(html, {"<td>stick radius, shakedown (over a)</td><td>3</td><td>2</td><td>1</td><td>0</td>"
                      "<td>3.0e-04</td><td>1.0e-04</td><td>1e-02</td><td>large</td>"});
}

TEST(VerdictSection, SetsWhatWasNotAskedForApart) {
  auto one = proved("bars"), other = proved("bars");
  EXPECT_EQ(rendered(verdict_section({one, other})).find("Not asked for"), std::string::npos);
  for (auto* r : {&one, &other}) r->json["comparison"]["normal_force_max"]["asked"] = false;
  const auto html = rendered(verdict_section({one, other}));
  EXPECT_LT(html.find("Not asked for"), html.find("largest normal force (relative)"));
}

// Of three shares, whatever their order.
TEST(BudgetSection, HasMedianAndLargestOfEachShare) {
  std::vector<StoredResult> results;
  for (const double estimate : {3e-4, 9e-4, 1e-4}) {
    results.push_back(proved("bars"));
    auto& bars = results.back().json["fe"]["error_estimate"];
    bars = {{"stick_radius_shakedown", {{"total", 1}, {"shares", {{"rings", {{"estimate", estimate}}}}}}}};
  }
  const auto html = rendered(budget_section(results));
  expect_parts(html, {"<th scope=\"col\">rings</th>", "<td>3e-04, 9e-04</td>"});
}

TEST(BudgetSection, HasASourceAColumnAndNothingWithoutBars) {
  auto other = proved("bars"), without = proved("none");
  for (auto& [quantity, bar] : other.json["fe"]["error_estimate"].items()) bar["shares"]["rings"]["estimate"] = 7e-2;
  for (auto& [quantity, bar] : without.json["fe"]["error_estimate"].items()) bar = nullptr;
  expect_parts(rendered(budget_section({proved("bars"), other, without})),
               {"<th scope=\"col\">rings</th>", "7e-02</td>", "<th scope=\"col\">time step</th>"});
  EXPECT_TRUE(budget_section({without}).is_null());
}

}  // namespace
}  // namespace fretval
