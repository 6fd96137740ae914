#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "comparison/run/batch.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::kept_results_test {
namespace {

namespace fs = std::filesystem;

/// A run of three cases, of which the second has lost its result.
class Interrupted : public testing::Test {
 protected:
  Interrupted() {
    write_sweep("0.4, 0.5, 0.6");
    first_ = go("");
    fs::remove(result("0.5"));
  }
  void write_sweep(const std::string& values, const std::string& scene = elastic_case()) {
    folder_.write("case.prm", scene + "subsection Sweep\n  set Entry = Friction / Coefficient\n  set Values = " +
                                  values + "\nend\n");
  }
  fretval::Run go(const std::string& options, const std::string& proof = "none") {
    return fretval_run("run " + quoted(folder_.path() / "case.prm") + " --no-store -o " + quoted(out()) + " --proof " +
                           proof + " " + options,
                       folder_);
  }
  [[nodiscard]] fs::path out() const { return folder_.path() / "out"; }
  [[nodiscard]] fs::path result(const std::string& value) const {
    return out() / "case" / ("coefficient-" + value) / "result.json";
  }
  ScratchFolder folder_;
  fretval::Run first_;
};

TEST_F(Interrupted, IsResumedWithTheSameResults) {
  ASSERT_EQ(first_.exit_code, 0) << first_.err;
  const auto before = text_of(result("0.4"));
  const auto resumed = go("--resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  expect_parts(resumed.err, {"2 of 3 cases kept of an earlier run"});
  EXPECT_EQ(text_of(result("0.4")), before) << "not written anew";
  EXPECT_TRUE(fs::exists(result("0.5")));
  EXPECT_EQ(resumed.out, first_.out);
}

TEST_F(Interrupted, IsComputedWhereInputsOrProofAreOthers) {
  expect_parts(go("--resume", "bars").err, {"0 of 3 cases kept"});
  write_sweep("0.4, 0.6", replace(elastic_case(), "Phase = 60", "Phase = 30"));
  expect_parts(go("--resume").err, {"0 of 2 cases kept"});
  auto json = nlohmann::json::parse(text_of(out() / "case/coefficient-0.4/run.json"));
  json["versions"]["fretval"] = "0.0.1";
  folder_.write("out/case/coefficient-0.4/run.json", json.dump());
  expect_parts(go("--resume").err, {"1 of 2 cases kept"});
}

// A table that a case names belongs to its inputs.
TEST_F(Interrupted, IsComputedWhereATableIsNewer) {
  const auto table = folder_.write("parabola.csv", "r,f\nmm,nm\n0,0\n0.5,12500\n1,50000\n1.5,112500\n2,200000\n");
  write_sweep("0.4, 0.5",
              replace(elastic_case(), "parabola\n  set Radius = 1e-2", "table\n  set Table = parabola.csv"));
  go("");
  expect_parts(go("--resume").err, {"2 of 2 cases kept"});
  fs::last_write_time(table, fs::last_write_time(result("0.5")) + std::chrono::seconds(2));
  expect_parts(go("--resume").err, {"0 of 2 cases kept"});
}

}  // namespace
}  // namespace fretval::kept_results_test
