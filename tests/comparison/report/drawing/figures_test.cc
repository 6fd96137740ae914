#include "comparison/report/drawing/figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

/// A point of a sweep over the phase with radii over the contact radius.
StoredResult phase_point(const char* rheology, double phase, double mdr, const nlohmann::ordered_json& fe) {
  StoredResult result{stored_result(), {}};
  auto& json = result.json;
  json["scene"]["rheology"] = rheology;
  json["scene"]["sweep"]["value"] = phase;
  json["scene"]["contact_radius_at_rest"] = 2;
  json["scene"]["contact_radius_unworn"] = 4;
  json["mdr"]["stick_radius_shakedown"] = mdr;
  json["fe"]["stick_radius_shakedown"] = fe;
  return result;
}

const std::vector<StoredResult>& phase_sweeps() {
  static const std::vector<StoredResult> results{
      phase_point("elastic", 0, 1, 1.5), phase_point("elastic", 90, 1, nullptr), phase_point("prony", 0, 1, 0.5)};
  return results;
}

TEST(Figures, HaveALineOfTheLeadingRheologyAndPointsOfAll) {
  const auto figures = stick_radius_figures(phase_sweeps());
  ASSERT_EQ(figures.size(), 2U) << "one for each criterion";
  const auto& series = figures[1].plot.series;
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0].style, Series::Style::line);
  EXPECT_EQ(series[0].y, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(series[1].style, Series::Style::points);
  EXPECT_EQ(series[1].x, (std::vector<double>{0, 90}));
  EXPECT_EQ(series[1].y[0], 0.75);
  EXPECT_TRUE(std::isnan(series[1].y[1])) << "nothing sticks";
  EXPECT_EQ(series[2].style, Series::Style::open_points);
  EXPECT_EQ(series[2].y, (std::vector<double>{0.25}));
}

TEST(Figures, HaveTheDifferencesWithoutTheirSignBesideTheTolerance) {
  const auto figures = difference_figures(phase_sweeps());
  ASSERT_EQ(figures.size(), 1U);
  const auto& series = figures[0].plot.series;
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[1].y[0], 0.125);
  EXPECT_EQ(series[1].y[2], 0.125);
  EXPECT_EQ(series[2].label, "tolerance");
  EXPECT_EQ(series[2].y, (std::vector<double>{0.01, 0.01}));
}

// Between two rows of the table: the mark lies on the curve where the wear ends.
TEST(Figures, MarkWhereTheWearEnds) {
  const ScratchFolder folder;
  folder.write("profile.csv", "r [m],f unworn [m],f limiting [m]\n0,0,0\n2,1,1\n4,3,2\n");
  folder.write("contact.csv", "r outer [m],surface height at d max [m]\n1,0.5\n3,1.5\n8,9\n");
  StoredResult result{stored_result(), folder.path()};
  auto& scene = result.json["scene"];
  scene["sweep"]["entry"] = "Wear / Stick radius ratio";
  scene["contact_radius_unworn"] = 2;
  scene["indentation"] = scene["normal_amplitude"] = 0.5;
  result.json["mdr"]["worn_radius"] = 3;
  const auto figures = limiting_profile_figures({result});
  ASSERT_EQ(figures.size(), 1U);
  const auto& plot = figures[0].plot;
  EXPECT_EQ(plot.series.back().x, std::vector<double>{1.5});
  EXPECT_EQ(plot.series.back().y, std::vector<double>{1.5});
  ASSERT_EQ(plot.series.size(), 3U);
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(plot.series[1].y, (std::vector<double>{0.5, 1.5})) << "up to there";
}

}  // namespace
}  // namespace fretval
