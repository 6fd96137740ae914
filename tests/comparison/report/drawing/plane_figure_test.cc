#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison/report/drawing/figures.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

const Series& series_of(const Plot& plot, const std::string& label) {
  return *std::find_if(plot.series.begin(), plot.series.end(), [&](const Series& s) { return s.label == label; });
}

// One ring of two points: a contact that reaches farther along x than across; one point sticks, the other one slips.
TEST(PlaneFigure, HasZonesAndTractionsWhereTheyAre) {
  const ScratchFolder folder;
  folder.write("zones.csv",
               "angle [rad],contact [m],never slipped [m],sticks in a cycle [m]\n0,0.002,0.001,0.001\n"
               "1.5707963267948966,0.001,0.0005,0.001\n");
  folder.write("surface.csv",
               "r inner [m],r outer [m],angle [rad],p [Pa],t_x [Pa],t_y [Pa],never slipped [1],sticks in a cycle [1]\n"
               "0,0.001,0,10,4,0,1,1\n0,0.001,1.5707963267948966,10,0,2,0,0\n");
  const auto plot = plane_figure({stored_result("single"), folder.path()}).plot;
  EXPECT_TRUE(plot.equal_scales);
  EXPECT_EQ(plot.x_label, "x in mm");
  const auto& contact = series_of(plot, "contact");
  EXPECT_NEAR(contact.x[0], 2, 1e-12);
  EXPECT_NEAR(contact.y[8], 1, 1e-12);
  EXPECT_NEAR(contact.x.back(), 2, 1e-12) << "it is closed";
  EXPECT_NEAR(std::hypot(contact.x[4], contact.y[4]), 1.5, 1e-12) << "halfway between two angles";
  EXPECT_NEAR(series_of(plot, "has never slipped").y[8], 0.5, 1e-12);
  const auto &stuck = series_of(plot, "traction where it sticks"),
             &slipping = series_of(plot, "traction where it slips");
  EXPECT_NEAR(stuck.x[0], 0.5, 1e-12);
  EXPECT_NEAR(slipping.y[0], 0.5, 1e-12);
  const double length = stuck.x[1] - stuck.x[0];
  EXPECT_GT(length, 0);
  EXPECT_NEAR(slipping.y[1] - slipping.y[0], length / 2, 1e-12) << "arrows are as long as tractions are large";
  EXPECT_NEAR(slipping.x[1], slipping.x[0], 1e-12);
  EXPECT_TRUE(std::isnan(stuck.y.back())) << "arrows are not joined";
}

TEST(PlaneFigure, HasTheCirclesThatMdrHas) {
  const PlaneEdges edges{{0, 1.5707963267948966}, {2e-3, 1e-3}, {1e-3, 5e-4}, {}};
  const auto plot = edges_figure(edges, {2.5e-3, 1.5e-3, 1.8e-3}).plot;
  EXPECT_NEAR(plot.x_range->second, 1.08 * 2.5, 1e-12) << "there is room for either contact";
  const auto& circle = series_of(plot, "has never slipped by MDR");
  for (std::size_t k = 0; k < circle.x.size(); ++k) EXPECT_LE(std::hypot(circle.x[k], circle.y[k]), 1.5 + 1e-12);
  EXPECT_NEAR(circle.x[0], 1.5, 1e-12);
  EXPECT_EQ(plot.series.size(), 4U) << "a single pass has no zone of a cycle, of neither method";
}

}  // namespace
}  // namespace fretval
