#include "comparison/report/drawing/plots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

std::string still_of(const Plot& plot) {
  const auto json = json_of(plot);
  return svgs({&json}).front();
}

// gnuplot would run what stands between backquotes in a double-quoted string.
TEST(Plots, TextIsText) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "here";
  Plot plot;
  plot.title = "`touch " + trace.string() + "` <script>";
  plot.x_label = "\"; system 'touch " + trace.string() + "'";
  plot.series.push_back({"`touch " + trace.string() + "`\n", {0, 1}, {0, 1}, Series::Style::line, 0});
  const std::string drawn = still_of(plot);
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
    return still_of(plot).find("a &amp; b: no data") == std::string::npos;
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

// Also where scripts are off: one point with a bar, one without, a mark inside the axis and one outside.
TEST(Plots, HaveTheirBarsAndMarksWithoutScripts) {
  Plot plot{"title", "x", "y"};
  plot.series.push_back({"curve", {1, 2}, {1, 2}, Series::Style::points, 1});
  const auto count = [&](const char* part) {
    const auto svg = still_of(plot);
    int n = 0;
    for (auto at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++n;
    return n;
  };
  const int paths = count("<path");
  plot.series[0].bar = {0.25, std::nan("")};
  const int with_a_bar = count("<path");
  EXPECT_GT(with_a_bar, paths);
  plot.x_range = {0, 4};
  plot.marks = {{"c_{FE}", 1.5}, {"outside", 5}};
  EXPECT_GT(count("stroke-dasharray"), 0);
  EXPECT_GT(count(">c<"), 0);
  EXPECT_EQ(count("outside"), 0);
}

TEST(Plots, AreDataOfThePage) {
  Plot plot{"title", "x", "y"};
  plot.series.push_back({"curve", {1, 2}, {std::nan(""), 1.23456789}, Series::Style::open_points, 3, {0, 0.25}});
  plot.marks = {{"c", 1.5}};
  plot.x_range = {0, 4};
  EXPECT_EQ(json_of(plot).dump(),
            R"({"title":"title","x_label":"x","y_label":"y","log_x":false,"log_y":false,"x_range":[0.0,4.0],)"
            R"("marks":[{"name":"c","x":1.5}],"series":[{"label":"curve","style":"open points","colour":3,)"
            R"("x":[1.0,2.0],"y":[null,1.23457],"bar":[0.0,0.25]}]})");
}

}  // namespace
}  // namespace fretval
