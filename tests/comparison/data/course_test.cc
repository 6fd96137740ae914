#include "comparison/data/course.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/simulation/fe_answer.h"

namespace fretval::course_test {
namespace {

constexpr auto first_slip = Quantity::stick_radius_first_slip, shakedown = Quantity::stick_radius_shakedown;

TEST(Course, IsThatOfThePath) {
  Case::Motion motion;
  EXPECT_EQ(course_of(motion), Course::cycles);
  motion.path.emplace();
  EXPECT_EQ(course_of(motion), Course::pass);
  motion.path->from_touch = true;
  EXPECT_EQ(course_of(motion), Course::pass_from_touch);
  motion.path->repeats = true;
  EXPECT_EQ(course_of(motion), Course::cycles);
}

TEST(Course, TakesTheStickRadiiAwayThatItDoesNotHave) {
  for (const auto course : {Course::cycles, Course::pass, Course::pass_from_touch}) {
    FeAnswer answer;
    answer.stick_radius_first_slip = answer.stick_radius_shakedown = 1;
    keep_to(course, answer);
    EXPECT_EQ(answer.course, course);
    EXPECT_EQ(answer.stick_radius_first_slip.has_value(), course != Course::pass_from_touch);
    EXPECT_EQ(answer.stick_radius_shakedown.has_value(), course == Course::cycles);
  }
}

// Of a pass nobody tells what the body has kept; stick radii that it does not have say why.
TEST(Course, LeavesReadingsOutThatAPassDoesNotHave) {
  const Readings all{{first_slip, {1}}, {shakedown, {1}}, {Quantity::bulk_work, {1}}, {Quantity::friction_work, {1}}};
  auto cycles = all, pass = all, from_touch = all;
  keep_to(Course::cycles, cycles);
  EXPECT_EQ(cycles.size(), all.size());
  EXPECT_EQ(cycles.at(shakedown).value, 1);
  keep_to(Course::pass, pass);
  EXPECT_EQ(pass.size(), all.size() - 1);
  EXPECT_EQ(pass.count(Quantity::bulk_work), 0U);
  EXPECT_EQ(pass.at(first_slip).value, 1);
  EXPECT_FALSE(pass.at(shakedown).value || pass.at(shakedown).is_compared);
  EXPECT_EQ(pass.at(shakedown).why_absent, "a single pass has no periodic state");
  keep_to(Course::pass_from_touch, from_touch);
  EXPECT_FALSE(from_touch.at(first_slip).value || from_touch.at(first_slip).is_compared);
  EXPECT_EQ(from_touch.at(first_slip).why_absent, nothing_at_rest);
}

TEST(Course, IsWrittenAndReadBack) {
  for (const auto course : {Course::cycles, Course::pass, Course::pass_from_touch}) {
    nlohmann::ordered_json scene{{"path", {{"file", "a.csv"}}}};
    add_course(course, scene["path"]);
    EXPECT_EQ(stored_course(scene), course);
    EXPECT_EQ(scene["path"].contains("why_no_shakedown"), is_pass(course));
  }
  EXPECT_EQ(stored_course(nlohmann::ordered_json::object()), Course::cycles) << "an oscillation";
}

}  // namespace
}  // namespace fretval::course_test
