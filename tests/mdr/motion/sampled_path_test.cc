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
  EXPECT_EQ(rest_position(triangle(true)).indentation, 2);
  EXPECT_EQ(rest_position(triangle(true)).tangential, 2);
  EXPECT_EQ(rest_position(triangle(false)).indentation, 3);
  EXPECT_EQ(rest_position(triangle(false)).tangential, 0);
  EXPECT_EQ(triangle(true).duration(), 4);
  EXPECT_EQ(maximum_indentation(triangle(true)), 3);
}

TEST(SampledPath, IsRefusedWhereItIsNone) {
  const auto refused = [](SampledPath path) { return error_of([&] { validate(path); }); };
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
