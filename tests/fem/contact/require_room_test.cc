#include "fem/contact/require_room.h"

#include <gtest/gtest.h>

#include "tests/fem/expect_solver_error.h"

namespace fretval::fem::require_room_test {
namespace {

TEST(RequireRoom, RefusesPressureOnTheLastRingAlone) {
  EXPECT_NO_THROW(require_room(Eigen::Vector3d(2, 1, 0)));
  EXPECT_NO_THROW(require_room(Eigen::Vector3d(0, 0, 0)));
  expect_solver_error([] { require_room(Eigen::Vector3d(2, 1, 1e-300)); }, {"end of the contact line", "a longer one"});
  expect_solver_error([] { require_room(Eigen::Vector3d(0, 0, 1)); }, {"end of the contact line"});
}

}  // namespace
}  // namespace fretval::fem::require_room_test
