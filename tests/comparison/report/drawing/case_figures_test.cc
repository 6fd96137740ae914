#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "comparison/report/drawing/figures.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

std::set<std::string> titles_of(const Filling& figures) {
  std::set<std::string> titles;
  const auto html = figures.dump();
  for (const char* title :
       {"Pressure and traction", "Stick, slip and open", "Motion of the indenter", "Tangential force over",
        "Normal force over", "Slip per period", "dies out", "Profile of the indenter", "The elastomer", "Error budget"})
    if (html.find(title) != std::string::npos) titles.insert(title);
  return titles;
}

/// What a run has written.
void write_tables(const ScratchFolder& folder) {
  folder.write("history.csv", "t [s],d [m],u_x [m],F_N [N],F_N MDR [N],F_x [N]\n0,1,0,1,1,0\n1,2,1,2,2,1\n");
  folder.write("contact.csv", "r outer [m],slip per period [m]\n1,0\n2,0.5\n");
  folder.write("profile.csv", "r [m],f unworn [m],f limiting [m]\n0,0,0\n2,1,1\n");
  folder.write("moduli.csv", "f [Hz],G' [Pa],G'' [Pa]\n1,1,1\n10,2,1\n");
  folder.write("cycle.json", R"({"r": [1, 2], "t": [1, 2], "p": [[4, 2], [2, 0]], "tau": [[1, 1], [-1, 0]],
                                 "zones": ["sf", "bo"], "slip_decay": [0.5, 0.25, 0]})");
}

TEST(CaseFigures, ShowWhatThereIs) {
  const ScratchFolder folder;
  const StoredResult result{stored_result("single"), folder.path()};
  EXPECT_EQ(titles_of(case_figures(result, read_cycle(result))), std::set<std::string>{"Error budget"});
  write_tables(folder);
  EXPECT_EQ(titles_of(case_figures(result, read_cycle(result))).size(), 10U);
  EXPECT_NE(case_figures(result, read_cycle(result)).dump().find("\"x\":[1.0,2.0,3.0],\"y\":[0.5,0.25,0.0]"),
            std::string::npos);
}

TEST(CaseFigures, CallANearCycleNoPeriod) {
  const ScratchFolder folder;
  write_tables(folder);
  StoredResult result{stored_result("single"), folder.path()};
  EXPECT_EQ(case_figures(result, read_cycle(result)).dump().find("near cycle"), std::string::npos);
  result.json["scene"]["has_period"] = false;
  const auto figures = case_figures(result, read_cycle(result)).dump();
  EXPECT_EQ(figures.find("period"), std::string::npos) << figures;
  expect_parts(figures, {"1.00 of the near cycle", "Slip per near cycle", "time over the near cycle",
                         "near cycle, from rest on", "never repeats"});
  result.json["scene"]["path"] = {{"repeats", "once"}};
  expect_parts(case_figures(result, read_cycle(result)).dump(), {"time over the pass", "1.00 of the pass"});
}

TEST(CaseFigures, RefuseADamagedCycleByItsName) {
  const ScratchFolder folder;
  const StoredResult result{stored_result("single"), folder.path()};
  for (const char* damaged : {"[{", R"({"r": 1})"}) {
    folder.write("cycle.json", damaged);
    EXPECT_NE(refusal([&] { case_figures(result, read_cycle(result)); }).find("cycle.json"), std::string::npos);
  }
}

// A caption of what is drawn, and of nothing else.
TEST(CaseFigures, CaptionsAreOfWhatThereIs) {
  const ScratchFolder folder;
  write_tables(folder);
  StoredResult result{stored_result("single"), folder.path()};
  const auto all = case_figures(result, read_cycle(result)).dump();
  expect_parts(all, {"The limiting profile is where wear ends", "Below c it slips no more.", "none inside c"});
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n2,1\n");
  result.json["fe"]["stick_radius_shakedown"] = nullptr;
  const auto less = case_figures(result, read_cycle(result)).dump();
  expect_parts(less, {"The indenter before anything wears.", "Nothing sticks for good."});
  EXPECT_TRUE(std::regex_search(less, std::regex("What each ring does in the [^.]*\\. Nothing sticks for good\\.")));
  for (const char* absent : {"where wear ends", "Below c", "Between c and a", "none inside c"})
    EXPECT_EQ(less.find(absent), std::string::npos) << absent;
}

}  // namespace
}  // namespace fretval
