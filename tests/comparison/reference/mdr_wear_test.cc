#include "comparison/reference/mdr_wear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/comparison/wearing_case.h"

namespace fretval::mdr_wear_test {
namespace {

std::optional<mdr::WearKinetics> kinetics_of(const std::string& wear, const std::string& motion = "") {
  const auto prepared = wearing_case(wear, motion);
  return wear_kinetics_of(prepared.input, prepared.mdr, 1e4);
}

TEST(MdrWear, HasKineticsOfLawsThatAreLinearInThePressure) {
  const auto archard = kinetics_of("  set Coefficient = 1e-12\n");
  ASSERT_TRUE(archard);
  const auto energy = kinetics_of("  set Law = energy\n  set Coefficient = 2e-12\n");
  EXPECT_NEAR(energy->curve.back().volume / archard->curve.back().volume, 1, 1e-12);
  EXPECT_FALSE(kinetics_of("  set Law = power\n  set Exponent = 2\n  set Coefficient = 1e-12\n"));
}

// Archard's volume of a cycle is k over mu times what friction takes from it; in few cycles nothing else changes.
TEST(MdrWear, OfACompressibleBodyIsThatOfItsSlip) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    auto input = wearing_case("  set Coefficient = 1e-12\n").input;
    input.elastomer.poisson_ratio = nu;
    const auto mdr = mdr_case(input);
    const auto kinetics = wear_kinetics_of(input, mdr, 10);
    ASSERT_TRUE(kinetics);
    const double friction = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr)).cycle->value(Quantity::friction_work);
    const auto& last = kinetics->curve.back();
    EXPECT_NEAR(last.volume / (last.cycles * 1e-12 / input.friction_coefficient * friction), 1, 1e-2) << nu;
    EXPECT_NEAR(last.friction_work / friction, 1, 1e-2) << nu;
  }
}

TEST(MdrWear, SaysEachNumberOfTheCourseUnderItsKey) {
  mdr::WearKinetics kinetics;
  kinetics.curve = {{0, 0, 0, 3, 4, 5}, {10, 1, 2, 6, 7, 8}};
  kinetics.radius = Eigen::Array2d(0.5, 1.5);
  kinetics.worn_depth = Eigen::Array2d(0, 0.25);
  EXPECT_EQ(to_json(kinetics), nlohmann::ordered_json::parse(R"({
    "cycles": [0.0, 10.0], "volume": [0.0, 1.0], "deepest": [0.0, 2.0], "friction_work": [3.0, 6.0],
    "contact_radius": [4.0, 7.0], "stick_radius": [5.0, 8.0], "r": [0.5, 1.5], "worn_depth": [0.0, 0.25]})"));
}

TEST(MdrWear, HasKineticsOfLockedMotionsOfOneFrequency) {
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Phase = free"));
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Tangential frequency = 2"));
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Phase = 90\n  set Normal harmonics = 1e-6, 2, 0"));
}

// On a layer wear ends in the layer's own state, whose stick radius is a little smaller than that of the unworn
// contact.
TEST(MdrWear, LimitsOnALayerAreItsOwn) {
  auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  auto input = prepared.input;
  input.body.shape = Case::Body::Shape::layer;
  input.body.thickness = 1.5e-3;
  const auto mdr = mdr_case(input);
  const auto answer = mdr_answer(mdr, mdr_normal_response(mdr));
  const auto limits = wear_limits(mdr, answer);
  EXPECT_TRUE(limits.reached);
  EXPECT_GT(limits.shakedown.stick_radius, 0.8 * answer.stick_radius_shakedown.value());
  EXPECT_LE(limits.shakedown.stick_radius, (1 + 1e-4) * answer.stick_radius_shakedown.value());
  EXPECT_LE(limits.first_slip.stick_radius, limits.shakedown.stick_radius);
  EXPECT_GT(limits.shakedown.volume, 0);
  EXPECT_FALSE(wear_kinetics_of(input, mdr, 1e4)) << "springs that wear do not know of each other";
}

TEST(MdrWear, LimitsBelongToEitherStickRadius) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  MdrAnswer answer{};
  answer.stick_radius_shakedown = 6e-4;
  const auto limits = wear_limits(prepared.mdr, answer);
  EXPECT_EQ(limits.shakedown.stick_radius, 6e-4);
  EXPECT_NEAR(limits.shakedown.maximum_indentation, 1e-4, 1e-18);
  EXPECT_NEAR(limits.first_slip.stick_radius, 1e-9, 1e-13) << "nothing sticks";
  EXPECT_NEAR(limits.first_slip.outer_radius, std::sqrt(2) * 1e-3, 1e-7) << "f0 = d_max";
}

// Triangles between 60 and 100 um: the course along a path is not that of one oscillation, and the limit is that of the
// deepest row.
TEST(MdrWear, OfAPathHasALimitAndNoKinetics) {
  const ScratchFolder folder;
  folder.write("path.csv", "t,d,u_x\ns,um,um\n0,60,0\n0.5,100,30\n1,60,0\n");
  auto text = wearing_text("  set Coefficient = 1e-12\n");
  const auto begin = text.find("  set Indentation"), end = text.find("end", begin);
  text.replace(begin, end - begin, "  set Path = path.csv\n  set Path repeats = forever\n");
  const auto prepared = prepare(read_case_file(folder.write("case.prm", text))).front();
  EXPECT_FALSE(wear_kinetics_of(prepared.input, prepared.mdr, 1e4));
  const auto answer = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
  const auto limits = wear_limits(prepared.mdr, answer);
  EXPECT_NEAR(limits.shakedown.maximum_indentation, 1e-4, 1e-16);
  EXPECT_EQ(limits.shakedown.stick_radius, answer.stick_radius_shakedown.value());
}

// Under a constant normal force F and a tangential force Q: c^3 = a^3 (1 - Q/(mu F)), a^3 = 3 F R/(16 G), and the disc
// bears the force alone in the end, F = 8 G (c d - c^3/(3 R)).
TEST(MdrWear, LimitUnderForcesIsWhatTheyPressTheWornIndenterTo) {
  const double force = 0.3, modulus = 1e6, radius = 1e-2, a = std::cbrt(3 * force * radius / (16 * modulus));
  const auto limits_under = [](const std::string& tangential) {
    const auto prepared = wearing_under_force(tangential);
    return wear_limits(prepared.mdr, mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)));
  };
  const auto limits = limits_under("set Tangential force amplitude = 0.06");
  const double c = a * std::cbrt(1 - 0.06 / (0.5 * force));
  EXPECT_NEAR(limits.shakedown.stick_radius / c, 1, 1e-9);
  EXPECT_NEAR(limits.shakedown.maximum_indentation / (force / (8 * modulus * c) + c * c / (3 * radius)), 1, 1e-9);
  EXPECT_TRUE(limits.reached);
  // A displacement drags a deeper contact no further: more of it sticks.
  EXPECT_FALSE(limits_under("set Tangential amplitude = 1.5e-5").reached);
}

TEST(WearLimit, OfAThickLayerIsThatOfTheHalfSpace) {
  const auto profile = mdr::parabola(1e-2);
  const auto half_space = wear_limit(mdr::limiting_profile(profile, 6e-4, 1e-4)),
             layer = wear_limit(mdr::layer_limiting_profile(profile, {1e3, 0.5}, 6e-4, 1e-4));
  EXPECT_EQ(half_space.stick_radius, 6e-4);
  EXPECT_NEAR(layer.outer_radius / half_space.outer_radius, 1, 1e-5);
  EXPECT_NEAR(layer.volume / half_space.volume, 1, 1e-4);
  for (const double r : {3e-4, 7e-4, 9e-4, 1.1e-3, 2e-3})
    EXPECT_NEAR(layer.height(r) / half_space.height(r), 1, 1e-4) << r;
}

// Volumes by shells of the heights, which are vertical at the stick radius.
TEST(WearLimit, HasTheVolumeOfItsHeights) {
  const auto profile = mdr::parabola(1e-2);
  const double c = 6e-4, pi = 3.14159265358979323846;
  for (const auto& limit : {wear_limit(mdr::limiting_profile(profile, c, 1e-4)),
                            wear_limit(mdr::layer_limiting_profile(profile, {5e-4, 0.45}, c, 1e-4))}) {
    constexpr int n = 4000;
    double volume = 0;
    const double width = limit.outer_radius - c;
    for (int i = 0; i < n; ++i) {
      const double s = (i + 0.5) / n, r = c + width * s * s;
      volume += 2 * pi * r * (limit.height(r) - r * r / 2e-2) * 2 * width * s / n;
    }
    EXPECT_NEAR(volume / limit.volume, 1, 1e-5);
  }
}

}  // namespace
}  // namespace fretval::mdr_wear_test
