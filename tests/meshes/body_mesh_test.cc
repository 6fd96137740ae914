#include "meshes/body_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval::meshes::body_mesh_test {
namespace {

TEST(ElementSize, IsTheSmallestOverAllContactElements) {
  const std::vector<double> nodes{0., 0.4, 0.5, 0.52, 0.8, 1.};
  for (const double r : {0., 0.1, 0.45, 0.51, 0.7, 0.9, 1., 3.})
    for (const double z : {0., -0.1, -1., -10.}) {
      double smallest = std::numeric_limits<double>::max();
      for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double a = nodes[i];
        const double b = nodes[i + 1];
        const double distance = std::hypot(r - std::clamp(r, a, b), z);
        smallest = std::min(smallest, std::max(b - a, 0.15 * distance));
      }
      EXPECT_DOUBLE_EQ(element_size(nodes, 0.15, r, z), smallest) << r << " " << z;
    }
}

}  // namespace
}  // namespace fretval::meshes::body_mesh_test
