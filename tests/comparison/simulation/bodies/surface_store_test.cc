#include "comparison/simulation/bodies/surface_store.h"

#include <gtest/gtest.h>

#include "comparison/simulation/bodies/body_store.h"

namespace fretval::surface_store_test {
namespace {

BodyDescription half_space(double scale) {
  BodyDescription body;
  body.contact_nodes = {0, 0.25, 0.5, 0.75, 1};
  body.growth = 0.5;
  body.far_radius = 12;
  body.degree = 2;
  body.scale = scale;
  return body;
}

TEST(SurfaceStore, MakesEachOrderOnceAndScalesIt) {
  BodyStore bodies;
  const auto few = find_or_make_surface(half_space(1), 1, bodies), more = find_or_make_surface(half_space(2), 2, bodies);
  ASSERT_EQ(few.orders.size(), 2U);
  ASSERT_EQ(more.orders.size(), 3U);
  EXPECT_DOUBLE_EQ(more.radii.back(), 2);
  EXPECT_LT((more.areas - 4 * few.areas).norm(), 1e-12);
  EXPECT_EQ((*more.orders[1] - 8 * *few.orders[1]).norm(), 0);  // the same block, not another one
}

// The ring contact's own bodies are made by other code, of one component.
TEST(SurfaceStore, HasTheRingContactInIt) {
  BodyStore bodies;
  const auto surface = find_or_make_surface(half_space(1.5), 1, bodies);
  const auto rings = find_or_make_body(half_space(1.5), bodies);
  const auto normal = fem::ring_compliance(surface, fem::axisymmetric),
             tangential = fem::ring_compliance(surface, fem::lateral);
  EXPECT_LT((*normal.matrix - *rings->normal.compliance.matrix).norm(), 1e-10 * normal.matrix->norm());
  EXPECT_LT((*tangential.matrix - *rings->tangential->compliance.matrix).norm(), 1e-10 * tangential.matrix->norm());
}

}  // namespace
}  // namespace fretval::surface_store_test
