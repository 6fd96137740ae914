#include "comparison/verification/random_cases/random_suite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "comparison/report/random_cases_section.h"
#include "comparison/support/quantile.h"
#include "comparison/support/random_numbers.h"
#include "comparison/support/resident_memory.h"
#include "comparison/verification/random_cases/random_json.h"
#include "comparison/verification/random_cases/random_table.h"
#include "fem/stick_zone/stick_depths.h"

namespace fretval {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

SoakRecord record(double error, double bar, std::size_t number = 0) {
  SoakRecord r;
  r.draw = {1, number};
  r.errors[1] = SoakError{0.6, 0.6 + error, bar, ErrorSource::rings};
  return r;
}

SoakRun run_of(std::vector<SoakRecord> records) {
  SoakRun run;
  run.seed = 1;
  run.records = std::move(records);
  return run;
}

TEST(RandomNumbers, AreTheSameEverywhere) {
  RandomNumbers random({1, 2, 3});
  // std::seed_seq and std::mt19937_64 by an independent program.
  std::seed_seq sequence{1, 2, 3};
  std::mt19937_64 bits(sequence);
  EXPECT_EQ(random.uniform(0, 1), static_cast<double>(bits() >> 11U) / 9007199254740992.0);
}

TEST(RandomNumbers, KeepTheirRangesAndWeights) {
  RandomNumbers random({7});
  std::vector<int> counts(3);
  for (int k = 0; k < 3000; ++k) {
    const double x = random.uniform(-2, 3), y = random.log_uniform(1e-3, 1e3);
    EXPECT_TRUE(x >= -2 && x < 3);
    EXPECT_TRUE(y >= 1e-3 * (1 - 1e-15) && y < 1e3 * (1 + 1e-12));
    EXPECT_LT(random.index(5), 5U);
    ++counts[random.weighted({1, 0, 2})];
  }
  EXPECT_EQ(counts[1], 0);
  EXPECT_NEAR(counts[2], 2000, 150);
}

TEST(Quantile, IsTheNearestRank) {
  EXPECT_FALSE(quantile({}, 0.5));
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
}

TEST(SoakCases, AreReproducibleAndVaried) {
  std::set<std::string> shapes, rheologies;
  int n_worn = 0, n_free = 0, n_at_rest = 0;
  for (std::size_t k = 0; k < 300; ++k) {
    const auto entries = soak_entries({1, k});
    if (k < 20) {
      EXPECT_EQ(entries, soak_entries({1, k}));
    }
    shapes.insert(entries.at("Indenter / Shape"));
    rheologies.insert(entries.at("Elastomer / Rheology"));
    n_worn += entries.count("Wear / State") > 0 ? 1 : 0;
    n_free += entries.at("Motion / Phase") == "free" ? 1 : 0;
    n_at_rest += entries.at("Motion / Tangential amplitude") == "0" ? 1 : 0;
  }
  EXPECT_EQ(shapes.size(), 5U);
  EXPECT_EQ(rheologies.size(), 5U);
  EXPECT_GT(n_worn, 0);
  EXPECT_GT(n_free, 0);
  EXPECT_GT(n_at_rest, 0);
  EXPECT_NE(soak_entries({1, 0}), soak_entries({2, 0}));
  EXPECT_NE(soak_entries({1, 0}), soak_entries({1, 0, 1}));
}

TEST(SoakRecord, FailsAboveItsBarOrWithoutNumbers) {
  EXPECT_EQ(failure_of(record(1e-3, 2e-3)), "");
  EXPECT_EQ(failure_of(record(-1e-3, 2e-3)), "");
  EXPECT_NE(failure_of(record(3e-3, 2e-3)).find("above its bar"), std::string::npos);
  EXPECT_NE(failure_of(record(not_a_number, 2e-3)), "");
  EXPECT_NE(failure_of(record(1e-3, not_a_number)), "");
  EXPECT_EQ(failure_of(record(1e-3, infinity)), "");
  EXPECT_EQ(failure_of(SoakRecord{}), "nothing was compared");
  auto broken = record(1e-3, 2e-3);
  broken.failure = "singular";
  EXPECT_EQ(failure_of(broken), "singular");
}

TEST(MemoryGrowth, SeesALeakAndNoSinglePeak) {
  const auto samples = [](double per_case, double peak) {
    std::vector<MemorySample> all;
    for (std::size_t k = 1; k <= 100; ++k) all.push_back({100 * k, 2e8 + per_case * 100 * static_cast<double>(k)});
    all.front().bytes = 1e8;  // not everything is there yet
    all.back().bytes += peak;
    return all;
  };
  EXPECT_TRUE(memory_growth(samples(0, 1e8))->is_flat());
  const auto leak = memory_growth(samples(10e3, 0)).value();
  EXPECT_FALSE(leak.is_flat());
  EXPECT_NEAR(leak.bytes_per_case(), 10e3, 300);
  EXPECT_FALSE(memory_growth({{100, 1e8}, {200, 2e8}}));
}

// The memory of the process is what the growth is made of: a leak of this test's own must be seen.
TEST(MemoryGrowth, SeesWhatTheProcessHolds) {
  const auto before = resident_bytes();
  if (!before) GTEST_SKIP() << "the system does not tell";
  std::vector<MemorySample> samples;
  std::vector<std::vector<double>> leaked;
  for (std::size_t k = 1; k <= 16; ++k) {
    leaked.emplace_back(500000, 1.0);  // 4 MB
    samples.push_back({k, resident_bytes().value()});
  }
  EXPECT_FALSE(memory_growth(samples)->is_flat());
}

TEST(SoakSummary, CountsAndOrders) {
  auto broken = record(0, 1, 3);
  broken.failure = "singular";
  const auto run = run_of({record(1e-3, 2e-3, 0), record(3e-3, 2e-3, 1), record(1e-3, infinity, 2), broken});
  const auto summary = summary_of(run);
  EXPECT_EQ(summary.n_cases, 4U);
  EXPECT_EQ(summary.n_failures, 1U);
  EXPECT_EQ(summary.n_above_bar, 1U);
  EXPECT_EQ(summary.distributions[1].n_unbounded, 1U);
  EXPECT_EQ(summary.worst[0]->draw.number, 3U);
  EXPECT_EQ(summary.worst[1]->draw.number, 1U);
  EXPECT_FALSE(summary.passes());
  EXPECT_TRUE(summary_of(run_of({record(1e-3, 2e-3)})).passes());
  EXPECT_FALSE(summary_of(run_of({record(3e-3, 2e-3)})).passes());
  EXPECT_NE(soak_table(run, summary).find("in 4 cases 1 failures, 1 of 4 errors are above their bar"),
            std::string::npos)
      << soak_table(run, summary);
  EXPECT_NE(soak_junit(summary).find("failures=\"2\""), std::string::npos) << soak_junit(summary);
}

TEST(SoakJson, HasWhatTheReportShows) {
  auto broken = record(not_a_number, infinity, 1);
  broken.failure = "<broken>";
  const auto run = run_of({record(1e-3, 2e-3), broken});
  const auto json = soak_json(run, summary_of(run));
  EXPECT_EQ(json["summary"]["failures"], 1);
  EXPECT_TRUE(json["worst"][0]["error"].is_null());
  EXPECT_NE(json["worst"][1]["case_file"].get<std::string>().find("subsection Motion"), std::string::npos);
  const auto html = soak_section(json);
  EXPECT_NE(html.find("&lt;broken&gt;"), std::string::npos) << html;
}

TEST(StickDepths, CarryADepthToTheRadius) {
  const Eigen::VectorXd radii = Eigen::VectorXd::LinSpaced(10, 0.05, 0.95);
  const auto depths_of = [&](auto g) {
    StickDepths depths{Eigen::VectorXd(10), radii};
    for (Eigen::Index j = 0; j < 10; ++j) depths.depth[j] = 0.25 - g(radii[j]);
    return depths;
  };
  // A cone: the radius is as uncertain as the depth.
  const auto cone = depths_of([](double r) { return r; });
  EXPECT_NEAR(reach_of_edge(cone, 0.25, 0.01), 0.01, 1e-12);
  // Under a flat face of 0.6, deep by 1e-4: nothing or all of it.
  StickDepths flat = depths_of([](double r) { return r < 0.6 ? 0.2499 : 0.2499 + r - 0.6; });
  EXPECT_LT(reach_of_edge(flat, 0.6, 1e-5), 0.11);
  EXPECT_NEAR(reach_of_edge(flat, 0.6, 1e-3), 0.6, 1e-12);
  flat.depth.array() -= 2e-4;
  EXPECT_GT(reach_of_edge(flat, 0, 1e-3), 0.5);
  EXPECT_EQ(reach_of_edge(flat, 0, 1e-5), 0);
}

TEST(StickDepths, ComeFromReservesAndSlip) {
  const Eigen::Vector3d reserve(0.3, 0.1, 0), slip(0, 0, 5);
  const auto depths = stick_depths({reserve, slip, 2}, Eigen::VectorXd::LinSpaced(5, 0.1, 0.9), 0.5, 1);
  EXPECT_TRUE(depths.depth.isApprox(Eigen::Vector3d(0.6, 0.2, -4)));
  EXPECT_EQ(depths.radius.size(), 3);
}

// Failures and numbers that are not finite are none at all; see docs/soak.md for the errors above their bars.
TEST(Soak, RunsEveryCaseWithFiniteNumbers) {
  SoakOptions options;
  options.n_cases = 40;
  options.batch = 20;
  const auto run = run_soak(options);
  const auto summary = summary_of(run);
  EXPECT_EQ(summary.n_failures, 0U) << soak_table(run, summary);
  EXPECT_EQ(summary.n_above_bar, 0U) << soak_table(run, summary);
  EXPECT_GT(summary.n_comparisons, 150U);
  EXPECT_EQ(run.memory.size(), 2U);
  EXPECT_GT(run.n_histories, 300);
}

// Cases of which an error was above its bar, by what their bars missed: a flat face that sticks as a whole by a depth
// that is smaller than its error; a phase that drifts faster than the body relaxes, unworn and worn; the edge of a
// contact that travels by half a ring.
TEST(SoakSlow, KeepsWhatItFoundWithinTheBars) {
  for (const std::size_t number : {3484U, 9942U, 1824U, 8680U}) {
    SoakOptions options;
    options.only = number;
    EXPECT_EQ(failure_of(run_soak(options).records.front()), "") << number;
  }
}

TEST(Soak, RepeatsASingleCase) {
  SoakOptions options;
  options.n_cases = 3;
  const auto all = run_soak(options);
  options.only = 2;
  const auto one = run_soak(options);
  ASSERT_EQ(one.records.size(), 1U);
  EXPECT_EQ(one.records[0].errors[1]->fe, all.records[2].errors[1]->fe);
  EXPECT_EQ(one.records[0].errors[1]->bar, all.records[2].errors[1]->bar);
}

}  // namespace
}  // namespace fretval
