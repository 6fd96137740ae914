#include "fem/ring_contact/slip_zones.h"

#include <gtest/gtest.h>

namespace fretval::fem::slip_zones_test {
namespace {

constexpr auto back = BoxState::lower, stuck = BoxState::interior, forth = BoxState::upper;
using Labels = std::vector<signed char>;

const Eigen::Vector3d pressed(1, 1, 1), lifted(1, 1, 0), none = Eigen::Vector3d::Zero();

TEST(SlipZones, RememberTheLastSlip) {
  SlipZones zones(3);
  zones.update(pressed, {stuck, forth, forth}, none);
  zones.update(pressed, {stuck, stuck, back}, none);
  EXPECT_EQ(zones.labels(),
            (Labels{SlipZones::never_slipped, SlipZones::slipped_forward, SlipZones::slipped_backward}));
  EXPECT_EQ(zones.slip(), (Labels{0, 0, -1}));
}

TEST(SlipZones, ForgetTheSlipOfARingThatLosesContact) {
  SlipZones zones(3);
  zones.update(pressed, {stuck, stuck, forth}, none);
  zones.update(lifted, {stuck, stuck, back}, none);  // a free ring is at both its limits
  EXPECT_EQ(zones.labels()[2], SlipZones::free);
  EXPECT_EQ(zones.slip()[2], 0);
  zones.update(pressed, {stuck, stuck, stuck}, none);
  EXPECT_EQ(zones.labels(), (Labels{SlipZones::never_slipped, SlipZones::never_slipped, SlipZones::touched_again}));
}

// The box solver leaves 1e-13 of a pressure; whether such a ring slips means nothing.
TEST(SlipZones, AreFreeAtRoundoffOfThePressure) {
  SlipZones zones(3);
  zones.update(Eigen::Vector3d(1e3, 1e3, 1e-10), {stuck, stuck, forth}, none);
  EXPECT_EQ(zones.labels()[2], SlipZones::free);
}

TEST(SlipZones, HoldWhatWasBeforeThePresentSlip) {
  SlipZones zones(3);
  zones.update(pressed, {stuck, stuck, forth}, Eigen::Vector3d(5, 4, 1));
  zones.update(pressed, {stuck, stuck, stuck}, Eigen::Vector3d(7, 6, 2));
  zones.update(pressed, {stuck, stuck, back}, Eigen::Vector3d(6, 5, -1));
  zones.update(pressed, {stuck, back, back}, Eigen::Vector3d(1, -1, -2));
  zones.update(pressed, {stuck, back, back}, Eigen::Vector3d(0, -1, -2));
  EXPECT_EQ(zones.held_depths()[1], 5 - 6);
  EXPECT_EQ(zones.held_depths()[2], 2 - 7);
  EXPECT_EQ(zones.held_labels(),
            (Labels{SlipZones::never_slipped, SlipZones::never_slipped, SlipZones::slipped_forward}));
  EXPECT_EQ(zones.depths(), Eigen::VectorXd(Eigen::Vector3d(0, -1, -2)));
}

}  // namespace
}  // namespace fretval::fem::slip_zones_test
