#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

std::string forces_html(const nlohmann::ordered_json& json) {
  return rendered(forces_section({StoredResult{json, {}}}));
}

TEST(ForcesSection, IsNotThereWithoutForces) {
  EXPECT_EQ(forces_html(stored_result()), "");
}

TEST(ForcesSection, ShowsWhatTheForcesLeadTo) {
  auto json = stored_result();
  json["name"] = "forced";
  json["scene"]["normal_force_mean"] = 0.5;
  json["scene"]["contact_radius_unworn"] = 2;
  json["mdr"]["stick_radius_shakedown"] = 0.75;
  json["fe"]["stick_radius_shakedown"] = 0.5;
  json["comparison"]["indentation_max"] = {{"difference", 3e-5}, {"error_bar", 4e-5}, {"tolerance", 1}, {"pass", true}};
  expect_parts(forces_html(json),
               {"<td>forced</td>", "<td>2.00000 m</td>", "<td>750.000 mm</td><td>500.000 mm</td>", "+3.0e-05 ± 4e-05"});
  EXPECT_EQ(forces_html(json).find("gross slip"), std::string::npos);
}

TEST(ForcesSection, SaysWhoFindsGrossSlip) {
  auto json = stored_result();
  json["scene"]["tangential_force_amplitude"] = 0.5;
  json["mdr"]["gross_slip"] = 0.8333;
  expect_parts(forces_html(json), {"gross slip at – of the amplitudes, at 0.83 says MDR"});
  json["fe"]["gross_slip"] = {{"time", 1.5}, {"amplitude", 0.875}};
  expect_parts(forces_html(json), {"gross slip at 0.88 of the amplitudes, at 0.83 says MDR"});
}

TEST(ForcesSection, SaysWhenAPassSlides) {
  auto json = stored_result();
  json["scene"]["tangential_force_amplitude"] = 0.5;
  json["scene"]["path"] = {{"repeats", "once"}};
  json["mdr"]["gross_slip"] = 1;
  json["mdr"]["gross_slip_time"] = 0.83333;
  json["fe"]["gross_slip"] = {{"time", 0.83332}, {"amplitude", 1}};
  expect_parts(forces_html(json), {"gross slip at t = 0.8333 s, at 0.8333 s says MDR"});
}

}  // namespace
}  // namespace fretval
