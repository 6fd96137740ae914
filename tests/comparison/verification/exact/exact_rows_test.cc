#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

// All rows: a heading, a line a row and the verdict.
TEST(ExactRowsSlow, AllPassAndAreTabulatedByTheProgram) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "exact.json";
  const auto run = fretval_run("check --suite exact --junit " + junit.string() + " --json " + json.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1 + 112 + 1) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"112\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).size(), 112U);
}

}  // namespace
}  // namespace fretval
