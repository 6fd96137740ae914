#include "mdr/motion/sampled_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::sampled_path_test {
namespace {

SampledPath triangle(bool repeats) {
  return {{1, 2, 5}, {3, 1, 3}, {0, 4, 0}, repeats};
}

TEST(SampledPath, RestsAtItsMeanOverTimeOrAtItsFirstRow) {
  EXPECT_EQ(rest_of(triangle(true)).normal, 2);
  EXPECT_EQ(rest_of(triangle(true)).tangential, 2);
  EXPECT_EQ(rest_of(triangle(false)).normal, 3);
  EXPECT_EQ(rest_of(triangle(false)).tangential, 0);
  EXPECT_EQ(triangle(true).duration(), 4);
  EXPECT_EQ(maximum_normal(triangle(true)), 3);
}

TEST(SampledPath, OfForcesRisesFromNoTangentialForce) {
  auto forces = triangle(true);
  forces.normal_force = forces.tangential_force = true;
  EXPECT_EQ(rest_of(forces).normal, 2);
  EXPECT_EQ(rest_of(forces).tangential, 0);
  forces.transverse = {1, 5, 1};
  EXPECT_EQ(rest_of(forces).transverse, 0) << "neither across";
  forces.tangential_force = false;
  EXPECT_EQ(rest_of(forces).transverse, 3) << "of a displacement";
  forces.tangential_force = true;
  EXPECT_EQ(error_of([&] { validate(forces); }), "accepted");
  forces.normal[1] = 0;
  EXPECT_NE(error_of([&] { validate(forces); }).find("normal force"), std::string::npos);
  forces = {{0, 1}, {1, 1}, {0.1, 1}, false, true, true};
  EXPECT_NE(error_of([&] { validate(forces); }).find("without tangential force"), std::string::npos);
}

TEST(SampledPath, IsRefusedWhereItIsNone) {
  const auto refused = [](const SampledPath& path) { return error_of([&] { validate(path); }); };
  EXPECT_EQ(refused(triangle(true)), "accepted");
  EXPECT_NE(refused({{0}, {1}, {0}, false}).find("two rows"), std::string::npos);
  EXPECT_NE(refused({{0, 1}, {1, 1}, {0}, false}).find("two rows"), std::string::npos);
  EXPECT_NE(refused({{0, 0}, {1, 1}, {0, 1}, false}).find("rise"), std::string::npos);
  EXPECT_NE(refused({{0, 1}, {1, 1}, {0, 1}, true}).find("end where it begins"), std::string::npos);
  EXPECT_NE(refused({{0, 1}, {0, 1}, {0, 1}, false}).find("at rest"), std::string::npos);
  EXPECT_NE(refused({{0, 1}, {1, std::nan("")}, {0, 1}, false}), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::sampled_path_test
