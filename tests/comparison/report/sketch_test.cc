#include "comparison/report/sketch.h"

#include <gtest/gtest.h>

#include <cstdlib>

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
}

}  // namespace
}  // namespace fretval
