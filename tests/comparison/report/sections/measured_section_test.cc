#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(MeasuredSection, HasWhatWasMeasuredBesideBothMethods) {
  StoredResult result{stored_result("single"), {}};
  EXPECT_TRUE(measured_table(result).is_null());
  result.json["measured"]["stick_radius_shakedown"] = {{"value", 0.8e-3}, {"uncertainty", 2e-5},
                                                       {"fe", 0.79e-3},   {"fe_difference", -1e-5},
                                                       {"mdr", nullptr},  {"mdr_difference", nullptr}};
  expect_parts(measured_table(result).dump(), {"800 ± 20 µm", "790", "none", "-1.2 %, 0.5 σ"});
}

TEST(MeasuredSection, SaysWhatWasMadeOfTheData) {
  StoredResult result{stored_result("single"), {}};
  EXPECT_TRUE(data_sentences(result).is_null());
  result.json["scene"]["path"] = {{"columns", {"t", "d", "F_x"}}};
  result.json["scene"]["data"] = {
      {"test_duration",
       {{"duration", 3600.0},
        {"slow_branches", 20},
        {"branches_of_data", 51},
        {"merged_branches", 22},
        {"merging_error", 4e-5}}},
      {"record",
       {{"rows", 200'000},
        {"rows_before_contact", 30},
        {"rows_kept", 400},
        {"cycles", 20},
        {"normal_scatter", 3e-8},
        {"tangential_scatter", 0.01},
        {"normal_error", 1e-8},
        {"tangential_error", 2e-3}}},
      {"trace", {{"apex", 1.4e-4}, {"apex_uncertainty", 9e-7}, {"tilt", 0.2}, {"tilt_uncertainty", 0.01}}},
      {"hardness", {{"shore_a", 50}, {"scatter", 0.2}}}};
  expect_parts(
      data_sentences(result).dump(),
      {"lasts 3600 s: 20 of 51 branches",
       "200000 rows, 30 of them before contact; it is folded to the mean of 20 cycles",
       "which scatter by 3e-08 m normally and 0.01 N", "400 rows stand for it within 1e-08 m normally and 0.002 N",
       "apex 140 µm ± 900 nm off, tilted by 0.2 ± 0.01°", "50 Shore A", "20 %"});
  auto& record = result.json["scene"]["data"]["record"];
  record["normal_error"] = record["tangential_error"] = 0;
  expect_parts(data_sentences(result).dump(), {"400 rows stand for it. What"});
}

}  // namespace
}  // namespace fretval
