#include "meshes/grading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/meshes/expect_error.h"

namespace fretval::meshes::grading_test {
namespace {

std::vector<double> sizes(const std::vector<double>& nodes) {
  std::vector<double> sizes;
  for (std::size_t i = 1; i < nodes.size(); ++i) sizes.push_back(nodes[i] - nodes[i - 1]);
  return sizes;
}

TEST(UniformNodes, AreEquidistantBetweenExactEnds) {
  const auto nodes = uniform_nodes(1.2, 128);
  ASSERT_EQ(nodes.size(), 129U);
  EXPECT_EQ(nodes.front(), 0.);
  EXPECT_EQ(nodes.back(), 1.2);
  for (const double size : sizes(nodes)) EXPECT_NEAR(size, 1.2 / 128, 1e-15);
}

TEST(UniformNodes, RefuseNoLengthAndNoElements) {
  expect_error([] { uniform_nodes(0., 4); }, {"length is 0", "positive"});
  expect_error([] { uniform_nodes(std::nan(""), 4); }, {"length is nan", "positive"});
  expect_error([] { uniform_nodes(1., 0); }, {"number of elements is 0", "at least 1"});
}

TEST(GradedNodes, HaveTheEdgeAndTheEndsExactly) {
  for (const double edge : {0.1, 0.3, 0.7 / 3, 1.}) {
    const auto nodes = graded_nodes({edge, edge, 1e-5}, 1.2, 0.02, 0.15);
    EXPECT_EQ(nodes.front(), 0.);
    EXPECT_EQ(nodes.back(), 1.2);
    EXPECT_TRUE(std::binary_search(nodes.begin(), nodes.end(), edge));
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  }
}

// Ten tenths are a little less than one, and 0.4 less 0.1 is a little more than three: no reason for one more.
TEST(GradedNodes, AreNoneMoreThanFit) {
  for (const FineBlock block :
       {FineBlock{0, 0, 0.1}, FineBlock{1, 1, 0.1}, FineBlock{0, 1, 0.1}, FineBlock{0.1, 0.4, 0.1}}) {
    const auto nodes = graded_nodes(block, 1, 0.1, 0);
    ASSERT_EQ(nodes.size(), 11U);
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], 0.1 * static_cast<double>(i), 1e-15);
  }
}

// The common factor that makes a whole number of elements fit is above 1 - (largest size)/(length of the side).
TEST(GradedNodes, GrowFromTheFineToTheCoarseSize) {
  const double edge = 0.5;
  const double growth = 0.15;
  const auto nodes = graded_nodes({edge, edge, 1e-5}, 1.2, 0.02, growth);
  const auto h = sizes(nodes);
  const auto at_edge = std::lower_bound(nodes.begin(), nodes.end(), edge) - nodes.begin();
  for (const auto i : {at_edge - 1, at_edge}) {
    EXPECT_LE(h[i], 1e-5 * (1 + 1e-9));
    EXPECT_GE(h[i], 1e-5 * (1. - 0.02 / 0.5));
  }
  EXPECT_LE(*std::max_element(h.begin(), h.end()), 0.02 * (1 + 1e-12));
  EXPECT_GE(h.front(), 0.02 * (1. - 0.02 / 0.5));
  EXPECT_GE(h.back(), 0.02 * (1. - 0.02 / 0.7));
  // Roundoff of a difference of nodes, relative to the smallest size: 1e-16/1e-5.
  for (auto i = at_edge; i + 1 < static_cast<long>(h.size()); ++i) EXPECT_LE(h[i + 1] / h[i], 1. + growth + 1e-9);
  for (auto i = at_edge - 1; i > 0; --i) EXPECT_LE(h[i - 1] / h[i], 1. + growth + 1e-9);
}

TEST(GradedNodes, AreUniformWithoutGrading) {
  const auto nodes = graded_nodes({0.5, 0.5, 0.125}, 1., 0.125, 0.15);
  const auto uniform = uniform_nodes(1., 8);
  ASSERT_EQ(nodes.size(), uniform.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], uniform[i], 1e-15);
}

TEST(GradedNodes, GradeFromOneSideAtTheEnds) {
  const auto towards_axis = sizes(graded_nodes({0., 0., 1e-3}, 1., 0.1, 0.2));
  EXPECT_TRUE(std::is_sorted(towards_axis.begin(), towards_axis.begin() + 20));
  const auto towards_end = sizes(graded_nodes({1., 1., 1e-3}, 1., 0.1, 0.2));
  EXPECT_LT(towards_end.back(), 1e-3 * (1 + 1e-9));
}

TEST(GradedNodes, HaveEqualElementsInTheBlock) {
  const auto nodes = graded_nodes({0.2, 0.31, 0.02}, 1., 0.1, 0.15);
  const auto begin = std::find(nodes.begin(), nodes.end(), 0.2), end = std::find(nodes.begin(), nodes.end(), 0.31);
  ASSERT_EQ(end - begin, 6);
  for (auto node = begin; node != end; ++node) EXPECT_NEAR(node[1] - node[0], 0.11 / 6, 1e-15);
  EXPECT_GT(end[2] - end[1], 0.02);
}

TEST(GradedNodes, RefuseWhatCannotBeGraded) {
  expect_error(
      [] {
        graded_nodes({1.3, 1.3, 0.01}, 1.2, 0.1, 0.1);
      },
      {"inner end of the block is 1.3", "between 0 and the length"});
  expect_error(
      [] {
        graded_nodes({0.5, 0.4, 0.01}, 1.2, 0.1, 0.1);
      },
      {"outer end of the block is 0.4", "between the inner end and the length"});
  expect_error([] { graded_nodes({0.5, 0.5, 0.}, 1.2, 0.1, 0.1); }, {"fine size is 0", "at least 1e-9"});
  expect_error(
      [] {
        graded_nodes({0.5, 0.5, 0.1}, 1.2, 0.01, 0.1);
      },
      {"coarse size is 0.01", "at least the fine size"});
  expect_error([] { graded_nodes({0.5, 0.5, 0.01}, 1.2, 0.1, -0.1); }, {"growth is -0.1", "at least 0"});
  expect_error([] { graded_nodes({0.5, 0.5, 1e-8}, 1.2, 0.1, 0.); }, {"fine size 1e-08", "more than 100000 elements"});
}

}  // namespace
}  // namespace fretval::meshes::grading_test
