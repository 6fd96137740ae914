#include "meshes/mesh.h"

#include <gtest/gtest.h>

#include "tests/meshes/block.h"

namespace fretval::meshes::mesh_test {
namespace {

TEST(Mesh, PartsOfTheBoundaryHaveNamesAndNumbersOfTheirGroups) {
  EXPECT_EQ(boundary_name(static_cast<Boundary>(1)), "axis");
  EXPECT_EQ(boundary_name(static_cast<Boundary>(2)), "contact");
  EXPECT_EQ(boundary_name(static_cast<Boundary>(3)), "free");
  EXPECT_EQ(boundary_name(static_cast<Boundary>(4)), "far");
}

TEST(Mesh, LengthIsThatOfOnePartOfTheBoundary) {
  EXPECT_EQ(boundary_length(block(), Boundary::axis), 2);
  EXPECT_EQ(boundary_length(block(), Boundary::contact), 1);
  EXPECT_EQ(boundary_length(block(), Boundary::free), 1);
  EXPECT_EQ(boundary_length(block(), Boundary::far), 4);
  EXPECT_EQ(boundary_length({{{0, 0}, {3, -4}}, {}, {{{1, 0}, Boundary::far}}}, Boundary::far), 5);
  EXPECT_EQ(boundary_length({}, Boundary::far), 0);
}

TEST(Mesh, ContactRadiiAreSortedAndThereOnce) {
  using B = Boundary;
  const Mesh mesh{{{2, 0}, {0, 0}, {7, 0}, {1, 0}, {0, -3}},
                  {},
                  {{{0, 3}, B::contact}, {{0, 2}, B::free}, {{1, 3}, B::contact}, {{4, 1}, B::axis}}};
  EXPECT_EQ(contact_radii(mesh), (std::vector<double>{0, 1, 2}));
  EXPECT_TRUE(contact_radii({}).empty());
}

}  // namespace
}  // namespace fretval::meshes::mesh_test
