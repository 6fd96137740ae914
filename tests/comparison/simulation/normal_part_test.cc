#include "comparison/simulation/normal_part.h"

#include <gtest/gtest.h>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/simulation/bodies/body_store.h"
#include "tests/comparison/suite_case.h"

namespace fretval::normal_part_test {
namespace {

// Friction has no part in it: cases that differ in that share the record.
TEST(NormalPart, IsSharedByCasesOfOtherFriction) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  BodyStore bodies;
  const auto part_of = [&](const Case& input) {
    const auto fem = prepare({input}).front().fem;
    const auto body = find_or_make_body(fem.body, bodies);
    return normal_part({body->normal, &*body->tangential}, fem, bodies.normals);
  };
  const auto first = part_of(scene);
  scene.friction_coefficient *= 2;
  const auto second = part_of(scene);
  EXPECT_EQ(first.record, second.record);
  EXPECT_NEAR(first.contact_radius->radius, 1, 1e-3);
}

}  // namespace
}  // namespace fretval::normal_part_test
