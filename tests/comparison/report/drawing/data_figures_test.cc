#include <gtest/gtest.h>

#include "comparison/report/drawing/figures.h"
#include "tests/comparison/stored_result.h"

namespace fretval::data_figures_test {
namespace {

/// A trace with its apex 0.14 mm off, its files in the folder of the result.
void add_trace(const ScratchFolder& folder, StoredResult& result) {
  result.json["scene"]["data"]["trace"] = {{"apex", 1.4e-4}, {"apex_uncertainty", 2e-6},
                                           {"tilt", 0.2},    {"tilt_uncertainty", 0.01},
                                           {"noise", 2e-8},  {"heights", "upwards"}};
  folder.write("trace.csv", "x [m],z [m],residual [m]\n-1e-3,0,nan\n0,1e-5,2e-8\n1e-3,0,-2e-8\n");
  folder.write("aligned_profile.csv", "r [m],f [m]\n0,0\n1e-3,1e-5\n");
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n1e-3,1e-5\n");
}

TEST(DataFigures, OfATraceAreItsRowsTheProfileAndWhatIsLeft) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  EXPECT_TRUE(trace_figures(result).empty());
  add_trace(folder, result);
  const auto figures = trace_figures(result);
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[0].plot.series[0].x.size(), 3U);
  EXPECT_NE(figures[0].caption.find("tilt of the stage at 0.2 ± 0.01°"), std::string::npos) << figures[0].caption;
  EXPECT_EQ(figures[1].plot.series.size(), 2U);
  EXPECT_EQ(figures[2].plot.series[0].y.size(), 2U);  // none where there is no profile
}

// Apex 0.14 mm off in a trace of millimetres, noise of 20 nm in residuals of nanometres.
TEST(DataFigures, HaveTheirMarksAndNumbersInTheUnitsOfTheirAxes) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  add_trace(folder, result);
  const auto figures = trace_figures(result);
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_NEAR(figures[0].plot.marks.at(0).second, 0.14, 1e-12);
  EXPECT_NEAR(figures[0].plot.series[0].x.back(), 1, 1e-12);
  EXPECT_NEAR(figures[0].plot.series[0].y[1], 10, 1e-12) << "in µm";
  EXPECT_NE(figures[0].caption.find("at 0.14 ± 0.002 mm"), std::string::npos) << figures[0].caption;
  EXPECT_NEAR(figures[2].plot.series[0].y[0], 20, 1e-12);
  EXPECT_NE(figures[2].caption.find("Noise: 20 nm"), std::string::npos) << figures[2].caption;
}

TEST(DataFigures, OfLoopsAreThoseThatWereMeasured) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  EXPECT_TRUE(measured_series(result, "u_x [m]", "F_x [N]", 1, 1).empty());
  folder.write("measured_loops.csv", "t [s],u_x [m],F_x [N]\n5,1e-6,2\n6,2e-6,4\n");
  const auto loop = measured_series(result, "u_x [m]", "F_x [N]", 1e-6, 2);
  ASSERT_EQ(loop.size(), 1U);
  EXPECT_EQ(loop[0].y, (std::vector<double>{1, 2}));
  EXPECT_EQ(measured_series(result, "t [s]", "F_x [N]", 1, 1)[0].x, (std::vector<double>{0, 1}));
  EXPECT_TRUE(measured_series(result, "d [m]", "F_N [N]", 1, 1).empty());
}

TEST(ModuliFigure, SaysHowWellABodyStandsForMeasuredModuli) {
  const ScratchFolder folder;
  StoredResult result{stored_result("single"), folder.path()};
  folder.write("moduli.csv", "f [Hz],G' [Pa],G'' [Pa]\n1,1,1\n10,2,1\n");
  folder.write("measured_moduli.csv", "f [Hz],G' [Pa],G'' [Pa]\n3,1.5,1.25\n");
  auto& fit = result.json["scene"]["fit_of_moduli"];
  fit = {{"residual", 0.012}, {"worst", 0.03}, {"worst_frequency", 4.0}, {"kramers_kronig", nullptr}};
  const auto sparse = filling_of({moduli_figure(result)}).dump();
  for (const char* part : {"by 1.2 %", "most at 4 Hz by 3 %", "too sparse", "\"x\":[3.0],\"y\":[1.25]"})
    EXPECT_NE(sparse.find(part), std::string::npos) << part;
  fit["kramers_kronig"] = {{"consistent", false}};
  EXPECT_NE(filling_of({moduli_figure(result)}).dump().find("contradict each other"), std::string::npos);
}

}  // namespace
}  // namespace fretval::data_figures_test
