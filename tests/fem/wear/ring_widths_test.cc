#include "fem/wear/ring_widths.h"

#include <gtest/gtest.h>

#include <utility>

namespace fretval::fem {
namespace {

TEST(RingWidths, AreThoseOfTheRingsBesideARadius) {
  const std::vector<double> radii{0, 0.5, 0.75, 1};
  const auto widths = [&](double radius) {
    const auto [inside, outside] = rings_at(radii, radius);
    return std::pair(inside, outside);
  };
  EXPECT_EQ(widths(0), std::pair(0.0, 0.5));
  EXPECT_EQ(widths(0.5), std::pair(0.5, 0.25));
  EXPECT_EQ(widths(1), std::pair(0.25, 0.0));
}

}  // namespace
}  // namespace fretval::fem
