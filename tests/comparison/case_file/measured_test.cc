#include "comparison/case_file/measured.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/refusal.h"

namespace fretval::measured_test {
namespace {

Case read(const std::string& entries,
          const std::string& loops = "F_x [mN];u_x [um];F_N [N]\n1,5;2;0,5\n-1,5;-2;0,4\n") {
  const ScratchFolder folder;
  folder.write("loops.csv", loops);
  return read_case_file(folder.write("case.prm", valid_case + "subsection Measured\n" + entries + "end\n")).at(0);
}

TEST(Measured, HasRadiiAndLoops) {
  const auto measured =
      read("set Loops = loops.csv\nset Stick radius = 0.8 mm\nset Stick radius uncertainty = 20 um\n").measured;
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->stick_radius->value, 0.8e-3, 1e-15);
  EXPECT_NEAR(measured->stick_radius->uncertainty, 20e-6, 1e-15);
  EXPECT_FALSE(measured->contact_radius);
  ASSERT_EQ(measured->tangential_force.size(), 2U);
  EXPECT_NEAR(measured->tangential_force[0], 1.5e-3, 1e-15);
  EXPECT_NEAR(measured->tangential_displacement[1], -2e-6, 1e-18);
  EXPECT_EQ(measured->normal_force[1], 0.4);
  EXPECT_TRUE(measured->time.empty() && measured->indentation.empty());
  EXPECT_FALSE(read_case().measured);
}

TEST(Measured, IsRefusedByName) {
  expect_parts(refusal([] { read("set Stick radius = 1 mm\n"); }), {"Measured / Stick radius uncertainty is missing"});
  expect_parts(refusal([] { read("set Stick radius uncertainty = 1 um\n"); }), {"it belongs to a Stick radius"});
  expect_parts(refusal([] { read("set Loops = other.csv\n"); }), {"Loops = other.csv", "the name of a file"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "t [s],d [um]\n0,1\n"); }), {"neither a column F_N nor"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "F_x [N],q [V]\n0,1\n"); }), {"loops.csv"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "F_x,u_x\n0,1\n"); }), {"no unit"});
}

}  // namespace
}  // namespace fretval::measured_test
