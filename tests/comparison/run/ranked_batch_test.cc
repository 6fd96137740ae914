#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "comparison/run/batch.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_ranks.h"

namespace fretval::ranked_batch_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Six quick cases, one of which fails: its branch of 1e12 cycles creeps on for ever.
void write_cases(const ScratchFolder& folder) {
  const auto coarse = replace(valid_case, "Tolerance = 0.01",
                              "Tolerance = 0.05\n  set Rings per radius = 16\n  set Steps per cycle = 16");
  folder.write("sweep.prm", coarse + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:45:180\nend\n");
  folder.write("creeping.prm", replace(coarse, "times = 0.1", "times = 1e12"));
}

const std::string run_all = "run sweep.prm creeping.prm --proof none --no-store ";

json without_costs(const fs::path& result) {
  auto content = json::parse(text_of(result));
  content.at("cost").erase("seconds");
  if (content.at("cost").contains("all")) content["cost"]["all"].erase("seconds");
  content.at("cost").erase("peak_memory_bytes");
  return content;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  return files;
}

// The same files with the same bytes, but for what they cost and the page that shows it.
TEST(RankedBatchSlow, ComesToWhatOneProcessComesTo) {
  const ScratchFolder folder;
  write_cases(folder);
  const auto alone =
      shell_run("cd " + quoted(folder.path()) + " && " FRETVAL_PROGRAM " " + run_all + "-o alone", folder);
  EXPECT_EQ(alone.exit_code, 3) << alone.err;
  for (const int n_ranks : {2, 3}) {
    const auto out = folder.path() / std::to_string(n_ranks);
    const auto ranked = ranked_run(n_ranks, run_all + "-o " + quoted(out), folder);
    EXPECT_EQ(ranked.exit_code, 3) << ranked.err;
    EXPECT_EQ(ranked.out, alone.out);
    EXPECT_EQ(files_below(out), files_below(folder.path() / "alone"));
    int n_results = 0;
    for (const auto& file : files_below(out)) {
      const auto name = fs::path(file).filename();
      if (name == "result.json") {
        ++n_results;
        EXPECT_EQ(without_costs(out / file), without_costs(folder.path() / "alone" / file)) << file;
      } else if (name != "index.html" && name != "run.json") {
        EXPECT_EQ(text_of(out / file), text_of(folder.path() / "alone" / file)) << file;
      }
    }
    EXPECT_EQ(n_results, 5);
  }
}

/// Differences are roundoff of the operators; those of error shares, which are differences themselves, do not count.
void expect_close(const json& a, const json& b) {
  for (const char* key :
       {"contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown", "normal_force_max"}) {
    const double x = a.at("fe").at(key), y = b.at("fe").at(key);
    EXPECT_LT(std::abs(x - y), 1e-9 * std::abs(y)) << key;
  }
  EXPECT_EQ(a.at("cost").at("dofs"), b.at("cost").at("dofs"));
}

TEST(RankedBatchSlow, MakesLargeBodiesTogether) {
  const ScratchFolder folder;
  folder.write("case.prm", valid_case);
  const auto alone = fretval_run(
      "run " + quoted(folder.path() / "case.prm") + " --no-store -o " + quoted(folder.path() / "alone"), folder);
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  const auto expected = json::parse(text_of(folder.path() / "alone/case/result.json"));
  for (const char* how : {"makes", "finds"}) {
    const auto out = folder.path() / how;
    const auto run = ranked_run(2, "-v run case.prm --distribute-from 1 --store store -o " + quoted(out), folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    expect_parts(run.err,
                 {"no fields are written", how == std::string("makes") ? ", 0 from the store" : "0 bodies made"});
    expect_close(json::parse(text_of(out / "case/result.json")), expected);
    EXPECT_FALSE(fs::exists(out / "case/fields.pvd"));
  }
}

}  // namespace
}  // namespace fretval::ranked_batch_test
