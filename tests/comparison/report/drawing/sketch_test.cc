#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "comparison/report/drawing/figures.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(Sketch, IsToScale) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  EXPECT_TRUE(sketch_of(result).is_null()) << "without the files of the case";
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n1,0.5\n2,2\n");
  folder.write("contact.csv", "r outer [m],surface height at d max [m]\n1,0.5\n2,1\n");
  result.json["scene"]["contact_radius_unworn"] = 1;
  result.json["scene"]["indentation"] = 0.375;
  result.json["scene"]["normal_amplitude"] = 0.125;
  result.json["fe"]["stick_radius_shakedown"] = 0.5;
  const auto sketch = sketch_of(result);
  const auto at = [](const Filling& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); };
  const double a = at(sketch["a_right"]) - at(sketch["a_left"]);
  EXPECT_NEAR((at(sketch["stick"]["right"]) - at(sketch["stick"]["left"])) / a, 0.5, 1e-3) << "c / a";
  EXPECT_NEAR((at(sketch["bottom"]) - at(sketch["level"])) / a, 0.25, 1e-3) << "d / 2a";
  EXPECT_TRUE(sketch["motions"].empty());
  for (const char* key : {"indenter", "surface"}) {
    const auto points = sketch[key].get<std::string>();
    const auto height_at = [&](std::size_t from) { return points.substr(points.find(',', from) + 1, 5); };
    EXPECT_EQ(height_at(0), height_at(points.rfind(' ', points.size() - 2))) << key << " is its own mirror image";
  }
  result.json["fe"]["indentation_max"] = 0.25;
  result.json["scene"].erase("tangential_amplitude");
  result.json["fe"]["tangential_amplitude"] = 0.0125;
  const auto under_force = sketch_of(result);
  const double radius = at(under_force["a_right"]) - at(under_force["a_left"]);
  EXPECT_NEAR((at(under_force["bottom"]) - at(under_force["level"])) / radius, 0.125, 1e-3) << "as the body gave way";
  EXPECT_EQ(under_force["slide"]["u"], "12.5 mm");
  EXPECT_EQ(at(under_force["slide"]["left"]) + at(under_force["slide"]["right"]), under_force["width"]);
}

// Over a width of 250 from 20 on and from 690 on, 62 high from 40 on.
TEST(Sketch, ShowsBothMotionsOverTime) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n1,0.5\n2,2\n");
  folder.write("contact.csv", "r outer [m],surface height at d max [m]\n1,0.5\n2,1\n");
  folder.write("history.csv", "t [s],d [m],u_x [m]\n3,8e-5,0\n4,1.2e-4,0\n5,1e-4,0\n");
  auto motions = sketch_of(result)["motions"];
  ASSERT_EQ(motions.size(), 1U) << "what does not move has no line";
  EXPECT_EQ(motions[0]["points"], "20.0,102.0 145.0,40.0 270.0,71.0 ");
  EXPECT_EQ(motions[0]["title"], "d(t) = 80 to 120 µm");
  folder.write("history.csv", "t [s],d [m],u_x [m]\n3,8e-5,-1e-6\n4,1.2e-4,1e-6\n");
  motions = sketch_of(result)["motions"];
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[1]["points"], "690.0,102.0 940.0,40.0 ");
  EXPECT_EQ(motions[1]["title"], "uₓ(t) = -1 to 1 µm");
}

// Forty cycles of eight rows: twelve swings are six of them.
TEST(Sketch, ShowsTheFirstOfManyCycles) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n1,0.5\n2,2\n");
  folder.write("contact.csv", "r outer [m],surface height at d max [m]\n1,0.5\n2,1\n");
  const auto n_points = [&](int n_cycles) {
    std::string rows = "t [s],d [m],u_x [m]\n";
    for (int i = 0; i < 8 * n_cycles; ++i)
      rows += std::to_string(i) + "," + std::to_string(2 + std::cos(i * std::acos(-1) / 4)) + ",0\n";
    folder.write("history.csv", rows);
    const auto motion = sketch_of(result)["motions"].at(0);
    const auto points = motion["points"].get<std::string>(), title = motion["title"].get<std::string>();
    EXPECT_EQ(title.find("first cycles") != std::string::npos, n_cycles == 40) << title;
    EXPECT_NE(title.find("1 to 3 m"), std::string::npos) << title;
    return std::count(points.begin(), points.end(), ',');
  };
  EXPECT_EQ(n_points(10), 80);
  EXPECT_NEAR(static_cast<double>(n_points(40)), 6 * 8, 4);
}

}  // namespace
}  // namespace fretval
