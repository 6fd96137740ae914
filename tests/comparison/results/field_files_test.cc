#include <gtest/gtest.h>

#include <cmath>

#include "comparison/results/case_result.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/small_body.h"
#include "tests/fem/vtu_data.h"

namespace fretval::field_files_test {
namespace {

namespace fs = std::filesystem;

/// The made-up result with four rings of a small body, which move as one by so much, step by step. Lengths are of 2 m,
/// depths of 0.5 m, pressures of 2.5 Pa; a step takes 1 s.
CaseResult result_with_body() {
  auto result = made_up_result();
  auto& fe = result.fe.fe;
  fe.whole_body = std::make_shared<const Body>(make_body(small_body()));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(4);
  fe.normal.displacement = ones * Eigen::RowVector4d(0.7, 0.5, 0.6, 1);
  fe.friction.displacement = ones * Eigen::RowVector4d(-0.1, -0.05, 0.1, 0.25);
  fe.normal.pressure = ones * Eigen::RowVector4d(3, 1, 2, 4);
  fe.friction.traction = ones * Eigen::RowVector4d(-1, -0.5, 1, 2);
  return result;
}

void write(const CaseResult& result, Case::Fields fields, const ScratchFolder& folder) {
  write_field_files(result.fe.fe, result.fem_case, fields, folder.path());
}

/// A component of a field of a file where it is nearest to x, y, z.
double at_point(const std::string& file, const std::string& field, std::size_t component, double x, double z) {
  const auto points = vtu_data(file, ""), values = vtu_data(file, field);
  const std::size_t n = values.size() / (points.size() / 3);
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t k) {
    return std::hypot(points[3 * k] - x, points[3 * k + 1], points[3 * k + 2] - z);
  };
  for (std::size_t k = 0; k < points.size() / 3; ++k)
    if (distance(k) < distance(nearest)) nearest = k;
  EXPECT_LT(distance(nearest), 1e-6);
  return values[n * nearest + component];
}

// The period ends with step 12; the deepest step is the last one, the highest the second, at 10 s.
TEST(FieldFiles, OfTheExtremesAreInTheOrderOfTime) {
  const ScratchFolder folder;
  write(result_with_body(), Case::Fields::extremes, folder);
  for (const char* series : {"fields", "surface"}) {
    const auto pvd = text_of(folder.path() / (std::string(series) + ".pvd"));
    EXPECT_EQ(n_of("timestep=", pvd), 2);
    EXPECT_LT(pvd.find("timestep=\"10\""), pvd.find("timestep=\"12\"")) << pvd;
    EXPECT_NE(pvd.find("timestep=\"12\""), std::string::npos);
  }
  EXPECT_NE(text_of(folder.path() / "fields.pvd").find("file=\"fields/section-01.vtu\""), std::string::npos);
  EXPECT_NE(text_of(folder.path() / "surface.pvd").find("file=\"fields/surface-01.vtu\""), std::string::npos);
}

// Of rings that all move by one depth the middle does so too, but for what four rings miss; it moves down and along x.
TEST(FieldFiles, HaveTheDisplacementsOfTheirInstantInMetres) {
  const ScratchFolder folder;
  write(result_with_body(), Case::Fields::extremes, folder);
  const auto file = [&](const char* name) { return text_of(folder.path() / "fields" / name); };
  constexpr double x = 1;  // the middle of the line
  for (const char* what : {"section", "surface"}) {
    const auto highest = file((std::string(what) + "-00.vtu").c_str()),
               deepest = file((std::string(what) + "-01.vtu").c_str());
    EXPECT_NEAR(at_point(highest, "displacement (m)", 2, x, 0), 0.25, 0.01) << what;
    EXPECT_NEAR(at_point(highest, "displacement (m)", 0, x, 0), -0.025, 0.06) << what;
    EXPECT_NEAR(at_point(deepest, "displacement (m)", 2, x, 0), 0.5, 0.02) << what;
    const double right = at_point(deepest, "displacement (m)", 0, x, 0),
                 left = at_point(deepest, "displacement (m)", 0, -x, 0);
    EXPECT_NEAR((right + left) / 2, 0.125, 0.01) << "without what the normal harmonic draws inwards";
  }
}

// Far from the edge of the line pressure and traction are what holds the surface: -p = s_zz and -tau = s_xz.
TEST(FieldFiles, HaveTheTractionsOfTheirInstantInPascal) {
  const ScratchFolder folder;
  write(result_with_body(), Case::Fields::cycle, folder);
  const auto last = text_of(folder.path() / "fields/surface-03.vtu");
  EXPECT_FLOAT_EQ(static_cast<float>(at_point(last, "contact pressure (Pa)", 0, 1, 0)), 10);
  EXPECT_FLOAT_EQ(static_cast<float>(at_point(last, "shear traction (Pa)", 0, 1, 0)), 5);
  EXPECT_EQ(at_point(last, "zone (0 open, 1 sticks, 2 slips forward, 3 backward)", 0, 1, 0), 2) << "tau = mu p";
  const auto section = text_of(folder.path() / "fields/section-03.vtu");
  EXPECT_NEAR(at_point(section, "stress (Pa)", 8, 0, 0), -10, 0.5);
  EXPECT_NEAR(at_point(section, "stress (Pa)", 2, 0, 0), -5, 0.5);
}

// A cycle of four steps has no more than these.
TEST(FieldFiles, OfACycleHaveAllItsSteps) {
  const ScratchFolder folder;
  write(result_with_body(), Case::Fields::cycle, folder);
  const auto pvd = text_of(folder.path() / "fields.pvd");
  EXPECT_EQ(n_of("timestep=", pvd), 4);
  for (const char* time : {"\"9\"", "\"10\"", "\"11\"", "\"12\""}) EXPECT_NE(pvd.find(time), std::string::npos) << time;
}

TEST(FieldFiles, OfAnEarlierRunAreGoneAndNothingElse) {
  const ScratchFolder folder;
  write(result_with_body(), Case::Fields::cycle, folder);
  folder.write("fields/notes.txt", "mine");
  write(result_with_body(), Case::Fields::extremes, folder);
  EXPECT_TRUE(fs::exists(folder.path() / "fields/section-01.vtu"));
  EXPECT_FALSE(fs::exists(folder.path() / "fields/section-02.vtu"));
  write(result_with_body(), Case::Fields::none, folder);
  EXPECT_FALSE(fs::exists(folder.path() / "fields/section-01.vtu"));
  EXPECT_FALSE(fs::exists(folder.path() / "surface.pvd"));
  EXPECT_TRUE(fs::exists(folder.path() / "fields/notes.txt"));
}

TEST(FieldFiles, AreNotThereOfGrossSlip) {
  auto result = result_with_body();
  result.fe.fe.of_kind = GrossSlipStart{1, 0.5};
  const ScratchFolder folder;
  write(result, Case::Fields::cycle, folder);
  EXPECT_FALSE(fs::exists(folder.path() / "fields"));
}

}  // namespace
}  // namespace fretval::field_files_test
