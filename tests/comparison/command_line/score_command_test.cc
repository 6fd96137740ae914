#include "comparison/command_line/score_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(ScoreCommand, ExitsWithWhatTheNumbersComeTo) {
  const ScratchFolder folder;
  const auto file = folder.write("mine.csv", "contact_radius_max,normal_force_max\nmm,mN\n1.095,703\n");
  const auto score = [&](const std::string& options) {
    return fretval_run("score " + quoted(file) + " " + options, folder);
  };
  const auto good = score("--benchmark 01-hertz");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  expect_parts(good.out,
               {"01-hertz: 2 of 2 quantities agree within 0.01 with finite elements", "largest contact radius"});
  const auto strict = score("--benchmark 01-hertz --tolerance '0.1 %' --json");
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(strict.out).at("quantities").at("normal_force_max").at("agrees"), false);
  EXPECT_EQ(score("--benchmark hertz").exit_code, 2);
  const auto wrong = score("--benchmark 01-hertz --tolerance much");
  EXPECT_EQ(wrong.exit_code, 2);
  expect_parts(wrong.err, {"--tolerance much"});
  EXPECT_EQ(fretval_run("score nothing.csv --benchmark 01-hertz", folder).exit_code, 2);
}

}  // namespace
}  // namespace fretval
