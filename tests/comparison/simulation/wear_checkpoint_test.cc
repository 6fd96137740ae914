#include "comparison/simulation/wear_checkpoint.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::wear_checkpoint_test {
namespace {

namespace fs = std::filesystem;

struct Killed {};

Resolution coarse() {
  Resolution r = resolution_for_wear(resolution_for(1e-3, false));
  r.elements_per_radius = 16;
  r.degree = 2;
  r.steps_per_cycle = 24;
  r.worn_edge_ring = 1e-2;
  r.wear_jump = 0.02;
  return r;
}

WearSimulation simulated(const WearRun& run, const Resolution& resolution = coarse()) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  return simulate_wear(prepared.fem, *prepared.input.wear_kinetics, {0.6, 1.5}, resolution, shared_bodies(), run);
}

/// Runs until it has made so many jumps.
void killed_after(int n_jumps, const fs::path& folder) {
  const auto kill = [&](const WearSimulation&, const fem::WearCourse& course) {
    if (course.n_jumps == n_jumps) throw Killed();
  };
  EXPECT_THROW(simulated({folder, kill}), Killed);
}

fs::path only_file(const fs::path& folder) {
  const std::vector<fs::directory_entry> files{fs::directory_iterator(folder), {}};
  EXPECT_EQ(files.size(), 1u);
  return files.at(0).path();
}

int jumps_made(const fs::path& folder) {
  int n = 0;
  simulated({folder, [&](const auto&...) { ++n; }});
  return n;
}

TEST(WearCheckpoint, WearGoesOnFromItBitForBit) {
  const ScratchFolder folder;
  const auto whole = simulated({});
  const int n_killed = whole.course.n_jumps / 2;
  killed_after(n_killed, folder.path());
  int n_after = 0;
  const auto rest = simulated({folder.path(), [&](const auto&...) { ++n_after; }});
  EXPECT_EQ(n_after, whole.course.n_jumps - n_killed);
  EXPECT_EQ(rest.course.worn, whole.course.worn);
  EXPECT_EQ(rest.worn_radius, whole.worn_radius);
  EXPECT_EQ(jumps_made(folder.path()), 0);  // the end is kept too
}

TEST(WearCheckpoint, OneThatIsDamagedCountsAsNone) {
  const ScratchFolder folder;
  killed_after(3, folder.path());
  const auto file = only_file(folder.path());
  std::ifstream stream(file, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(stream), {}};
  const int all = simulated({}).course.n_jumps;
  const auto jumps_after = [&](const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
    return jumps_made(folder.path());
  };
  EXPECT_EQ(jumps_after(good), all - 3);
  auto flipped = good;
  flipped[good.size() / 2] ^= 1;
  for (const auto& bad : {flipped, good.substr(0, good.size() - 1), good.substr(0, 5), std::string()})
    EXPECT_EQ(jumps_after(bad), all) << bad.size();
}

// By their names they are told apart, and by what they say of themselves where those are the same.
TEST(WearCheckpoint, OneOfAnotherWearCountsAsNone) {
  const ScratchFolder folder;
  auto other = coarse();
  other.wear_jump *= 2;
  const int all = simulated({}, other).course.n_jumps;
  killed_after(3, folder.path());
  const auto of_first = only_file(folder.path());
  int n = 0;
  simulated({folder.path(), [&](const auto&...) { ++n; }}, other);
  EXPECT_EQ(n, all);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path() != of_first) fs::copy_file(of_first, entry.path(), fs::copy_options::overwrite_existing);
  n = 0;
  simulated({folder.path(), [&](const auto&...) { ++n; }}, other);
  EXPECT_EQ(n, all);
}

TEST(WearCheckpoint, WearGoesOnWhereNothingCanBeWritten) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "file") << "no folder";
  EXPECT_EQ(jumps_made(folder.path() / "file"), simulated({}).course.n_jumps);
}

// Each of them leads to another course: of friction, of the law, of how far it goes and of what the body remembers.
TEST(WearCheckpoint, OneOfAnotherCaseCountsAsNone) {
  const ScratchFolder folder;
  const auto first_jump = [&](const PreparedCase& prepared) {
    int n = 0;
    const auto kill = [&](const WearSimulation&, const fem::WearCourse& course) {
      n = course.n_jumps;
      throw Killed();
    };
    EXPECT_THROW(simulate_wear(prepared.fem, *prepared.input.wear_kinetics, {0.6, 1.5}, coarse(), shared_bodies(),
                               {folder.path(), kill}),
                 Killed);
    return n;
  };
  const auto usual = wearing_case("  set Coefficient = 1e-12\n");
  EXPECT_EQ(first_jump(usual), 1);
  EXPECT_EQ(first_jump(usual), 2) << "goes on from its checkpoint";
  auto other = usual;
  other.fem.friction_coefficient *= 1.01;
  EXPECT_EQ(first_jump(other), 1);
  other = usual;
  other.fem.relaxation.viscosity = 1e-3;
  EXPECT_EQ(first_jump(other), 1);
  EXPECT_EQ(first_jump(wearing_case("  set Coefficient = 1e-12\n  set Until = 1e-4\n")), 1);
  EXPECT_EQ(first_jump(wearing_case("  set Coefficient = 1e-12\n  set Cycles = 1e9\n")), 1);
  EXPECT_EQ(first_jump(wearing_case("  set Coefficient = 2e-12\n")), 1);
}

}  // namespace
}  // namespace fretval::wear_checkpoint_test
