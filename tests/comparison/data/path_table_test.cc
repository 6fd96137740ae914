#include "comparison/data/path_table.h"

#include <gtest/gtest.h>

#include <utility>

#include "comparison/case_file/case_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::path_table_test {
namespace {

const std::string saw = "t,d,u_x\nms,um,um\n0,100,-10\n500,120,10\n1000,100,-10\n";

Case::Path read(const std::string& text, bool repeats) {
  const ScratchFolder folder;
  std::vector<std::string> notes;
  return read_path_table(folder.write("path.csv", text), repeats, {}, notes);
}

std::string refused(const std::string& text, bool repeats) {
  return refusal([&] { static_cast<void>(read(text, repeats)); });
}

TEST(PathTable, IsReadWithItsUnits) {
  const auto path = read(saw, true);
  EXPECT_EQ(path.time, (std::vector<double>{0, 0.5, 1}));
  EXPECT_NEAR(path.normal[1], 1.2e-4, 1e-18);
  EXPECT_NEAR(path.tangential[0], -1e-5, 1e-19);
  EXPECT_TRUE(path.repeats);
  EXPECT_EQ(path.duration(), 1);
  EXPECT_NEAR(rest_of(path).normal, 1.1e-4, 1e-18);
  EXPECT_NEAR(rest_of(path).tangential, 0, 1e-18);
  EXPECT_NEAR(rest_of(read(saw, false)).normal, 1e-4, 1e-18);
  EXPECT_NEAR(rest_of(read(saw, false)).tangential, -1e-5, 1e-19);
  EXPECT_EQ(read("t [min];d [mm];u_x [nm]\n1;1;1\n2;1;1\n", false).time.front(), 60);
}

// A triangle that rises in a quarter of its time and falls in the rest has its mean in the middle.
TEST(PathTable, RestsAtItsMeanOverTime) {
  const auto path = read("t,d,u_x\ns,um,um\n0,100,5\n0.5,130,-3\n2,100,5\n", true);
  EXPECT_NEAR(rest_of(path).normal, 1.15e-4, 1e-18);
  EXPECT_NEAR(rest_of(path).tangential, 1e-6, 1e-18);
  const auto held = read("t,d,u_x\ns,um,um\n0,100,0\n1,100,0\n2,140,0\n3,140,0\n4,100,0\n", true);
  EXPECT_NEAR(rest_of(held).normal, 1.2e-4, 1e-18);
}

TEST(PathTable, IsReadInEveryDialect) {
  const auto path = read(
      "Rig;7\r\nu_x [\xB5m];T [\xB0"
      "C];d [mm];Zeit [ms]\r\n-10;21,5;0,1;0\r\n10;21,5;0,12;500\r\n-10;21,5;0,1;1000\r\n",
      true);
  const auto same = read(saw, true);
  EXPECT_EQ(path.time, same.time);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(path.normal[i], same.normal[i], 1e-18);
    EXPECT_NEAR(path.tangential[i], same.tangential[i], 1e-18);
  }
}

TEST(PathTable, TakesForcesInEitherDirection) {
  const auto forces = read("t,F_N,F_x\ns,mN,kN\n0,500,1e-12\n2,300,1e-3\n", false);
  EXPECT_TRUE(forces.normal_force && forces.tangential_force);
  EXPECT_NEAR(forces.normal[1], 0.3, 1e-15);
  EXPECT_NEAR(forces.tangential[1], 1, 1e-15);
  EXPECT_EQ(forces.tangential[0], 0);
  const auto mixed = read("t [s],F_N [N],u_x [um]\n0,1,3\n1,2,5\n2,1,3\n", true);
  EXPECT_TRUE(mixed.normal_force);
  EXPECT_FALSE(mixed.tangential_force);
  EXPECT_NEAR(rest_of(mixed).tangential, 4e-6, 1e-18);
  const auto pulled = read("t,d,F_x\ns,um,N\n0,100,3\n1,90,5\n2,100,3\n", true);
  EXPECT_FALSE(pulled.normal_force);
  EXPECT_EQ(rest_of(pulled).tangential, 0);
  expect_parts(refused("t,F_N,F_x\ns,N,N\n0,1,0\n1,2,0\n2,1.5,0\n", true), {"F_N jumps by -0.5 N"});
}

TEST(PathTable, GoesInTwoDirections) {
  const auto path = read("t,d,u_x,u_y\ns,um,um,mm\n0,100,0,1\n1,110,3,2\n2,100,0,1\n", true);
  EXPECT_NEAR(path.transverse[1], 2e-3, 1e-15);
  EXPECT_NEAR(rest_of(path).transverse, 1.5e-3, 1e-15);
  const auto forces = read("t,F_N,F_x,F_y\ns,N,N,mN\n0,1,0,0\n1,2,0.1,50\n", false);
  EXPECT_TRUE(forces.normal_force && forces.tangential_force);
  EXPECT_NEAR(forces.transverse[1], 0.05, 1e-15);
  EXPECT_EQ(rest_of(forces).transverse, 0);
  expect_parts(refused("t,d,u_x,F_y\ns,m,m,N\n0,1,0,0\n1,1,1,1\n", false), {"F_y beside u_x", "both forces"});
  expect_parts(refused("t,d,F_x,u_y\ns,m,N,m\n0,1,0,0\n1,1,1,1\n", false), {"u_y beside F_x"});
  expect_parts(refused("t,d,F_x,F_y\ns,m,N,N\n0,1,0,2\n1,1,1,1\n", false), {"F_y = 2 N in the first row"});
  expect_parts(refused("t,d,F_x,F_y\ns,m,N,N\n0,1,0,0\n1,1,1,1\n2,1,0,1\n", true), {"F_y jumps from 1 N", "to 0 N"});
}

TEST(PathTable, IsRefusedByName) {
  for (const auto& [text, part] : {std::pair("t,d,u_x\n0,1,0\n1,1,1\n", "column t has no unit"),
                                   {"0,1,0\n1,1,1\n", "no names of columns"},
                                   {"t,u_x,f\ns,m,Hz\n0,1,0\n1,1,1\n", "has no column for the indentation d or"},
                                   {"t,F_x,u_x\ns,N,m\n0,1,0\n1,1,1\n", "has a column u_x [m] and a column F_x [N]"},
                                   {"t,a,b\ns,m,m\n0,1,0\n1,1,1\n", "is not clear: a [m] or b [m]"},
                                   {"t,F_N,u_x\ns,m,m\n0,1,0\n1,1,1\n", "mN"},
                                   {"t,F_N,u_x\ns,N,m\n0,1,0\n1,-2,1\n", "line 4: F_N = -2 N: must be positive"},
                                   {"t,F_N,F_x\ns,N,N\n0,1,0.1\n1,1,1\n", "F_x = 0.1 N in the first row"},
                                   {"t,d,u_x\ns,m,furlong\n0,1,0\n1,1,1\n", "furlong"},
                                   {"t,d,u_x\ns,m,m\n0,1,0\n", "1 row"},
                                   {"t,d,u_x\ns,m,m\n0,1,0\n2,1,1\n1,1,1\n", "line 5: t = 1: must be greater"},
                                   {"t,d,u_x\ns,m,m\n0,1,0\n0,1,1\n", "must be greater"},
                                   {"t,d,u_x\ns,m,m\n0,1,0\n1,nan,1\n", "line 4"},
                                   {"t,d,u_x\ns,m,m\n0,-1,0\n1,1,1\n", "d = -1 m in the first row"}})
    expect_parts(refused(text, false), {"path.csv", part});
}

// In contact, but so little that the body bears nothing yet.
TEST(PathTable, OfAPassMayBeginAsTheIndenterTouches) {
  const auto path = read("t,d,u_x\ns,um,um\n0,0,0\n1,100,1\n", false);
  EXPECT_TRUE(path.from_touch);
  EXPECT_FALSE(read("t,d,u_x\ns,um,um\n0,1,0\n1,100,1\n", false).from_touch);
  EXPECT_GT(path.normal.front(), 0);
  EXPECT_LT(path.normal.front(), 1e-8 * path.normal.back());
  EXPECT_FALSE(read("t,d,u_x\ns,um,um\n0,0,0\n1,100,1\n2,0,0\n", true).from_touch) << "it comes back there";
}

TEST(PathTable, ThatRepeatsEndsWhereItBegins) {
  expect_parts(refused("t,d,u_x\ns,um,um\n0,100,0\n1,110,0\n2,90,0\n", true),
               {"d jumps by 1e-05 m", "from 9e-05 m in the last row to 0.0001 m", "shows no period", "once"});
  expect_parts(refused("t,d,u_x\ns,um,um\n0,100,0\n1,110,9\n2,100,3\n", true), {"u_x jumps by -3e-06 m"});
  expect_parts(refused("t,d,u_x\ns,um,um\n0,100,0\n1,100,0\n", true), {"2 rows", "repeats needs at least 3"});
  expect_parts(refused("t,d,u_x\ns,um,um\n0,1,0\n1,-9,0\n2,1,0\n", true), {"the mean of d over time is -4e-06 m"});
  const auto closed = read("t,d,u_x\ns,um,um\n0,100,5\n1,110,0\n2,100.00001,5\n", true);
  EXPECT_EQ(closed.normal.back(), closed.normal.front());
}

std::string case_with_path(const std::string& more = "") {
  const auto begin = valid_case.find("subsection Motion"), end = valid_case.find("subsection Accuracy");
  return valid_case.substr(0, begin) + "subsection Motion\n  set Path = path.csv\n" + more + "end\n" +
         valid_case.substr(end);
}

Case read_with_path(const std::string& text, const std::string& rows = saw) {
  const ScratchFolder folder;
  folder.write("path.csv", rows);
  return read_case_file(folder.write("case.prm", text)).at(0);
}

TEST(PathTable, StandsInTheCaseInsteadOfOscillations) {
  const auto input = read_with_path(case_with_path("  set Path repeats = forever\n"));
  ASSERT_TRUE(input.motion.path);
  EXPECT_NEAR(input.motion.indentation, 1.1e-4, 1e-18);
  EXPECT_NEAR(input.motion.normal_amplitude, 1e-5, 1e-18);
  EXPECT_NEAR(input.motion.tangential_amplitude, 1e-5, 1e-18);
  EXPECT_EQ(input.motion.normal_frequency, 1);
}

TEST(PathTable, OfForcesStandsInTheCaseInsteadOfThoseThatOscillate) {
  const auto input = read_with_path(case_with_path("  set Path repeats = forever\n"),
                                    "t,F_N,F_x\ns,N,N\n0,1,-0.1\n1,3,0.3\n2,1,-0.1\n");
  ASSERT_TRUE(input.motion.normal_force && input.motion.tangential_force);
  EXPECT_EQ(input.motion.normal_force->mean, 2);
  EXPECT_EQ(input.motion.normal_force->amplitude, 1);
  EXPECT_NEAR(*input.motion.tangential_force, 0.2, 1e-15);
}

TEST(PathTable, AndOscillationsExcludeEachOther) {
  const auto message = refusal([] {
    read_with_path(case_with_path("  set Path repeats = once\n  set Indentation = 1e-4\n  set Phase = 30\n"));
  });
  expect_parts(message, {"Motion / Indentation = 1e-4", "Motion / Phase = 30", "the Path is the motion"});
  expect_parts(refusal([] { read_with_path(case_with_path()); }), {"Motion / Path repeats is missing"});
  expect_parts(refusal([] { read_with_path(case_with_path("  set Path repeats = twice\n")); }),
               {"Path repeats = twice", "once, forever"});
  expect_parts(
      refusal([] {
        read_with_path(replace(valid_case, "  set Phase = 60\n", "  set Phase = 60\n  set Path repeats = once\n"));
      }),
      {"Path repeats = once", "it belongs to a Path"});
  expect_parts(refusal([] {
                 read_with_path(case_with_path("  set Path repeats = once\n") +
                                "subsection Wear\n  set Coefficient = 1e-13\nend\n");
               }),
               {"Wear / Coefficient = 1e-13", "that repeats forever"});
}

}  // namespace
}  // namespace fretval::path_table_test
