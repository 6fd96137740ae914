#include <gtest/gtest.h>

#include <fstream>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval::surface_wear_section_test {
namespace {

TEST(SurfaceWearSection, IsEmptyWithoutWear) {
  EXPECT_TRUE(surface_wear_section({{stored_result(), "nowhere"}}).is_null());
}

TEST(SurfaceWearSection, ShowsWhatSticksBesideTheLimitOfMdr) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "worn_surface.csv")
      << "r inner [m],r outer [m],angle [rad],f unworn [m],f worn [m],p largest at end [Pa]\n"
         "0,5e-4,1.5707963,1e-5,1e-5,2e5\n0,5e-4,4.712389,1e-5,1e-5,2e5\n"
         "5e-4,1e-3,1.5707963,5e-5,7e-5,0\n5e-4,1e-3,4.712389,5e-5,8e-5,0\n";
  auto json = stored_result();
  json["scene"]["indentation_max"] = 1e-4;
  json["fe"]["surface_wear"] = {{"cycles", {0, 1e6, 1e8}},
                                {"volume", {0, 1e-11, 3e-11}},
                                {"stick_radius", {7e-4, 6.8e-4, 6.6e-4}},
                                {"volume_bar", 3e-12},
                                {"sticks",
                                 {{"radius", 6.6e-4},
                                  {"radius_bar", 5e-5},
                                  {"along", 6.4e-4},
                                  {"along_bar", nullptr},
                                  {"across", 6.8e-4},
                                  {"across_bar", 4e-5}}},
                                {"limit_of_mdr", {{"stick_radius", 7.75e-4}, {"volume", 1.2e-11}}}};
  json["scene"]["contact_radius_unworn"] = 1e-3;
  const auto section = surface_wear_section({{json, folder.path()}});
  expect_parts(section.dump(), {"at 90 degrees", "at 270 degrees", "limit, MDR", "radius of what sticks"});
  expect_parts(rendered(section), {"Wear off the circle", "0.03 mm³ ± 10 %", "0.012 mm³", "660 ± 50 µm", "775.000 µm",
                                   "640.000 µm", "680 ± 40 µm"});
  // Heights belong to the middles of the rings, at 250 and 750 um.
  std::size_t n = 0;
  for (const auto& figure : section.at("shapes").at("figures"))
    for (const auto& series : figure.at("plot").at("series")) {
      if (series.at("label").get<std::string>().find("degrees") == std::string::npos) continue;
      ++n;
      EXPECT_NEAR(series.at("x")[1].get<double>() / series.at("x")[0].get<double>(), 3, 1e-9);
    }
  EXPECT_EQ(n, 2U);
}

}  // namespace
}  // namespace fretval::surface_wear_section_test
