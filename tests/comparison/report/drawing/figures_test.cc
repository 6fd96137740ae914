#include "comparison/report/drawing/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "comparison/run/sweep_line.h"
#include "tests/comparison/scratch_folder.h"
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
  json["scene"]["friction_coefficient"] = 0.5;
  json["scene"]["normal_amplitude"] = 2;
  json["scene"]["tangential_amplitude"] = 3;
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
  EXPECT_EQ(series[0].label, "k = 0.5") << "1.5 mu Dd/u_x0";
  EXPECT_EQ(series[0].y, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(series[1].style, Series::Style::points);
  EXPECT_EQ(series[1].x, (std::vector<double>{0, 90}));
  EXPECT_EQ(series[1].y[0], 0.75);
  EXPECT_TRUE(std::isnan(series[1].y[1])) << "nothing sticks";
  EXPECT_EQ(series[2].style, Series::Style::open_points);
  EXPECT_EQ(series[2].y, (std::vector<double>{0.25}));
}

// The line of a sweep is over the contact radius at rest, and of no use where results of another sweep are beside it.
TEST(Figures, HaveTheLineBetweenThePointsOfOneSweep) {
  const ScratchFolder folder;
  const auto quantity = Quantity::stick_radius_shakedown;
  folder.write("mdr.csv", column_of_entry("Motion / Phase") + "," + column_of(quantity) + "\n0,1\n45,1.5\n90,1\n");
  auto first = phase_point("elastic", 0, 1, 1.5), second = phase_point("elastic", 90, 1, 1.5);
  first.folder = folder.path() / "0";
  second.folder = folder.path() / "90";
  const auto line = [&] { return stick_radius_figures({first, second})[1].plot.series[0]; };
  EXPECT_EQ(line().x, (std::vector<double>{0, 45, 90}));
  EXPECT_EQ(line().y, (std::vector<double>{0.5, 0.75, 0.5}));
  second.json["scene"]["sweep"]["family"] = "another";
  EXPECT_EQ(line().x, (std::vector<double>{0, 90}));
}

TEST(Figures, LeaveOutForcesAndOtherFrequencies) {
  for (const auto& [key, value] : {std::pair{"normal_force_mean", 1.0}, {"tangential_frequency", 1e9}}) {
    auto other = phase_point("elastic", 0, 1, 1.5);
    other.json["scene"][key] = value;
    EXPECT_TRUE(stick_radius_figures({other}).empty()) << key;
  }
}

TEST(Figures, HaveCurvesInTheirUnits) {
  const ScratchFolder folder;
  folder.write("profile.csv", "r [m],f [m]\n0,0\n4,3\n");
  const auto curve = curve_from({stored_result(), folder.path()}, "profile.csv", "f [m]", 2, 0.5, {"look", {}, {}});
  EXPECT_EQ(curve.x, (std::vector<double>{0, 2}));
  EXPECT_EQ(curve.y, (std::vector<double>{0, 6}));
  const auto worn = over_cycles({{"cycles", {0, 10, 20}}, {"volume", {0, 2, 4}}}, "volume", 2, {"look", {}, {}});
  EXPECT_EQ(worn.x, (std::vector<double>{10, 20})) << "cycles are drawn by their logarithm";
  EXPECT_EQ(worn.y, (std::vector<double>{1, 2}));
}

TEST(Figures, HaveTheDifferencesWithoutTheirSignBesideTheTolerance) {
  const auto figures = difference_figures(phase_sweeps());
  ASSERT_EQ(figures.size(), 1U);
  const auto& series = figures[0].plot.series;
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0].style, Series::Style::open_points) << "first slip";
  EXPECT_EQ(series[1].style, Series::Style::points);
  EXPECT_EQ(series[1].y[0], 0.125);
  EXPECT_EQ(series[1].y[2], 0.125);
  EXPECT_EQ(series[2].label, "tolerance");
  EXPECT_EQ(series[2].y, (std::vector<double>{0.01, 0.01}));
}

// Between two rows of the table: the mark lies on the curve where the wear ends.
TEST(Figures, MarkWhereTheWearEnds) {
  const ScratchFolder folder;
  folder.write("profile.csv", "r [m],f unworn [m],f limiting [m]\n0,0,0\n2,1,1\n4,3,2\n");
  folder.write("contact.csv", "r outer [m],surface height at d max [m]\n1,0.5\n1.1,0.6\n3,1.5\n8,9\n");
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
  EXPECT_EQ(plot.series[1].y, (std::vector<double>{0.5, 1.5})) << "up to there, of 25 points";
}

}  // namespace
}  // namespace fretval
