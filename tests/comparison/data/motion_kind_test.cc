#include "comparison/data/motion_kind.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/simulation/fe_answer.h"

namespace fretval::motion_kind_test {
namespace {

constexpr auto first_slip = Quantity::stick_radius_first_slip, shakedown = Quantity::stick_radius_shakedown;

TEST(MotionKind, IsThatOfThePath) {
  Case::Motion motion;
  EXPECT_EQ(motion_kind_of(motion), MotionKind::cycles);
  motion.path = Case::Path{};
  EXPECT_EQ(motion_kind_of(motion), MotionKind::pass);
  motion.path->from_touch = true;
  EXPECT_EQ(motion_kind_of(motion), MotionKind::pass_from_touch);
  motion.path->repeats = true;
  EXPECT_EQ(motion_kind_of(motion), MotionKind::cycles);
}

TEST(MotionKind, TakesTheStickRadiiAwayThatItDoesNotHave) {
  for (const auto kind : {MotionKind::cycles, MotionKind::pass, MotionKind::pass_from_touch}) {
    FeAnswer answer;
    answer.stick_radius_first_slip = answer.stick_radius_shakedown = 1;
    keep_to(kind, answer);
    EXPECT_EQ(answer.motion_kind, kind);
    EXPECT_EQ(answer.stick_radius_first_slip.has_value(), kind != MotionKind::pass_from_touch);
    EXPECT_EQ(answer.stick_radius_shakedown.has_value(), kind == MotionKind::cycles);
  }
}

// Of a pass nobody tells what the body has kept; stick radii that it does not have say why.
TEST(MotionKind, LeavesReadingsOutThatAPassDoesNotHave) {
  const Readings all{{first_slip, {1}},
                     {shakedown, {1}},
                     {Quantity::bulk_work, {1}},
                     {Quantity::friction_work, {1}},
                     {Quantity::worn_radius, {1}}};
  auto cycles = all, pass = all, from_touch = all;
  keep_to(MotionKind::cycles, cycles);
  EXPECT_EQ(cycles.size(), all.size());
  EXPECT_EQ(cycles.at(shakedown).value, 1);
  keep_to(MotionKind::pass, pass);
  EXPECT_EQ(pass.size(), all.size() - 1);
  EXPECT_EQ(pass.count(Quantity::bulk_work), 0U);
  EXPECT_EQ(pass.at(first_slip).value, 1);
  for (const auto quantity : {shakedown, Quantity::worn_radius}) {
    EXPECT_FALSE(pass.at(quantity).value || pass.at(quantity).is_compared);
    EXPECT_EQ(pass.at(quantity).why_absent, "a single pass has no periodic state");
  }
  keep_to(MotionKind::pass_from_touch, from_touch);
  EXPECT_FALSE(from_touch.at(first_slip).value || from_touch.at(first_slip).is_compared);
  EXPECT_EQ(from_touch.at(first_slip).why_absent, nothing_at_rest);
}

TEST(MotionKind, IsWrittenAndReadBack) {
  for (const auto kind : {MotionKind::cycles, MotionKind::pass, MotionKind::pass_from_touch}) {
    nlohmann::ordered_json scene{{"path", {{"file", "a.csv"}}}};
    add_motion_kind(kind, scene["path"]);
    EXPECT_EQ(stored_motion_kind(scene), kind);
    EXPECT_EQ(scene["path"].contains("why_no_shakedown"), is_pass(kind));
  }
  EXPECT_EQ(stored_motion_kind(nlohmann::ordered_json::object()), MotionKind::cycles) << "an oscillation";
}

}  // namespace
}  // namespace fretval::motion_kind_test
