#include "comparison/report/plots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

// gnuplot would run what stands between backquotes in a double-quoted string.
TEST(Plots, TextIsText) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "here";
  Plot plot;
  plot.title = "`touch " + trace.string() + "` <script>";
  plot.x_label = "\"; system 'touch " + trace.string() + "'";
  plot.series.push_back({"`touch " + trace.string() + "`\n", {0, 1}, {0, 1}, Series::Style::line, 0});
  const std::string drawn = svgs({plot}).front();
  EXPECT_FALSE(std::filesystem::exists(trace));
  EXPECT_EQ(drawn.find("<script"), std::string::npos);
  EXPECT_NE(drawn.find("script"), std::string::npos);
}

// What an axis cannot show leaves a gap; a plot of gaps alone says so.
TEST(Plots, WithoutPointsSaySo) {
  Plot plot;
  plot.title = "a & b";
  const auto shows = [&](std::vector<double> x, std::vector<double> y) {
    plot.series = {{"curve", std::move(x), std::move(y)}};
    return svgs({plot}).front().find("a &amp; b: no data") == std::string::npos;
  };
  const double none = std::nan("");
  EXPECT_FALSE(shows({}, {}));
  EXPECT_FALSE(shows({none, 1}, {1, none}));
  EXPECT_TRUE(shows({-1, 1}, {-1, 1}));
  plot.log_y = true;
  EXPECT_FALSE(shows({1, 2}, {0, -1}));
  EXPECT_TRUE(shows({-1, 2}, {1, 10}));
  plot.log_x = true;
  EXPECT_FALSE(shows({-1, 0}, {1, 1}));
  EXPECT_TRUE(shows({-1, 1, 10}, {1, 1, none}));
}

}  // namespace
}  // namespace fretval
