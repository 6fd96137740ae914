#include "comparison/data/aligned_trace.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "comparison/reference/mdr_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::aligned_trace_test {
namespace {

/// A sphere of 10 mm, apex 0.14 mm off, tilted by 0.2 degrees, heights upwards, noise of 20 nm; mm and um.
std::string raw_trace() {
  std::mt19937 engine(2);
  std::normal_distribution<double> scatter(0, 0.02);
  std::string text = "Profilometer;7\nx [mm];z [\xB5m]\n";
  for (int i = 0; i <= 3000; ++i) {
    const double x = -1.5 + 0.001 * i, u = x - 0.14;
    const double z = 20 - 1e3 * (10 - std::sqrt(100 - u * u)) + 1e3 * std::tan(0.2 * M_PI / 180) * u + scatter(engine);
    text += fmt::format("{:.4f};{:.4f}\n", x, z);
  }
  for (char& c : text)
    if (c == '.') c = ',';
  return text;
}

TEST(AlignedTrace, IsTheSphereThatWasTraced) {
  const ScratchFolder folder;
  const auto trace = read_aligned_trace(folder.write("trace.csv", raw_trace()).string(), 0);
  EXPECT_TRUE(trace.heights_upwards);
  EXPECT_NEAR(trace.noise, 20e-9, 1e-9);
  EXPECT_NEAR(trace.apex, 0.14e-3, 3 * trace.apex_uncertainty);
  EXPECT_NEAR(trace.tilt, std::tan(0.2 * M_PI / 180), 3 * trace.tilt_uncertainty);
  EXPECT_LT(neighbour_of(trace, -1).apex, trace.apex);
  EXPECT_GT(neighbour_of(trace, 1).apex, trace.apex);
  EXPECT_EQ(read_aligned_trace(folder.write("b.csv", raw_trace()).string(), 40e-9).row_noise > 1.9 * trace.row_noise,
            true);
}

// A trace that lies elsewhere is as noisy as the case says.
TEST(AlignedTrace, KeepsItsNoiseInItsNeighbours) {
  const ScratchFolder folder;
  const auto trace = read_aligned_trace(folder.write("trace.csv", raw_trace()).string(), 40e-9);
  for (const int side : {-1, 1}) EXPECT_DOUBLE_EQ(neighbour_of(trace, side).row_noise, trace.row_noise);
}

// Each place is met three times, by heights 0, 1 and 5 um above the parabola.
TEST(AlignedTrace, TakesTheMeanOfTheRowsOfAPlace) {
  std::string text = "x,z\nmm,um\n";
  for (const double above : {0, 1, 5})
    for (int i = 0; i <= 100; ++i) {
      const double x = -1 + 0.02 * i;
      text += fmt::format("{:.6f},{:.9f}\n", x, 50 * x * x + above);
    }
  const ScratchFolder folder;
  const auto trace = read_aligned_trace(folder.write("trace.csv", text).string(), 0);
  ASSERT_EQ(trace.x.size(), 101U);
  for (std::size_t i = 0; i < trace.x.size(); ++i)
    EXPECT_NEAR(trace.z[i], 50 * trace.x[i] * trace.x[i] + 2e-6, 1e-12) << i;
}

std::string case_of_trace(const std::string& alignment) {
  const auto begin = valid_case.find("subsection Indenter"), end = valid_case.find("end\n", begin);
  return valid_case.substr(0, begin) + "subsection Indenter\nset Shape = table\nset Table = trace.csv\n" + alignment +
         valid_case.substr(end);
}

TEST(AlignedTrace, StandsInTheCase) {
  const ScratchFolder folder;
  folder.write("trace.csv", raw_trace());
  const auto input = read_case_file(folder.write("case.prm", case_of_trace("set Table alignment = fit\n"))).at(0);
  const auto profile = any_profile_of(input.indenter);
  const auto exact = mdr::sphere(10e-3);
  for (const double depth : {30e-6, 80e-6}) {
    const double a = mdr::inverse_transform(exact, depth);
    double off = 0;
    for (const int side : {-1, 1}) {
      auto other = input.indenter;
      other.trace = neighbour_of(*input.indenter.trace, side);
      off = std::max(
          off, std::abs(mdr::inverse_transform(any_profile_of(other), depth) - mdr::inverse_transform(profile, depth)));
    }
    EXPECT_NEAR(mdr::inverse_transform(profile, depth), a, 3 * off + 3e-4 * a);
  }
  expect_parts(input.notes.at(1), {"trace.csv: aligned: apex at 0.0001399", "heights upwards"});
  const auto& note = input.notes.at(1);
  EXPECT_NEAR(std::stod(note.substr(note.find("tilt ") + 5)), 0.2, 0.01) << "degrees";
}

TEST(AlignedTrace, IsNotTakenAsItIs) {
  const ScratchFolder folder;
  folder.write("trace.csv", raw_trace());
  const auto raw = read_case_file(folder.write("case.prm", case_of_trace(""))).at(0);
  EXPECT_FALSE(raw.indenter.trace);
  EXPECT_NE(refusal([&] { any_profile_of(raw.indenter); }), "no error");
  expect_parts(
      refusal([&] { read_case_file(folder.write("case.prm", case_of_trace("set Table alignment = best\n"))); }),
      {"Table alignment = best", "raw, fit"});
  expect_parts(refusal([&] { read_aligned_trace(folder.write("few.csv", "x,z\nmm,um\n0,0\n1,1\n").string(), 0); }),
               {"few.csv", "at least 32"});
}

}  // namespace
}  // namespace fretval::aligned_trace_test
