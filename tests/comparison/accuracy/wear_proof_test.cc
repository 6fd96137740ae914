#include "comparison/accuracy/wear_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/wearing_case.h"

namespace fretval {
namespace {

ProvedWear proved(const PreparedCase& prepared, Proof proof) {
  const auto mdr = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
  ProvedAnswer unworn{};
  unworn.fe = compute_case(prepared.fem, prepared.fem.resolution, shared_bodies());
  return prove_wear(prepared, mdr, unworn, proof, shared_bodies());
}

TEST(WearProof, WearsWhereTheCaseAsksForItAndSomethingSlips) {
  EXPECT_TRUE(wears(wearing_case("  set Coefficient = 1e-12\n")));
  EXPECT_FALSE(wears(wearing_case("")));
  EXPECT_FALSE(wears(wearing_case("  set Coefficient = 1e-12\n", "set Tangential amplitude = 0")));
}

// The paper's claim, without error bars: the end is the limiting profile of the shakedown radius.
TEST(WearProof, EndsInTheLimit) {
  const auto wear = proved(wearing_case("  set Coefficient = 1e-12\n"), Proof::none);
  ASSERT_EQ(wear.failure, "");
  EXPECT_TRUE(wear.ends_in_limit());
  EXPECT_LT(wear.pressed_outside, 1e-5);
  EXPECT_EQ(wear.cost.computations, 1);
  EXPECT_GT(wear.distance_shakedown.front(), 0.1);
  EXPECT_LT(wear.distance_shakedown.back(), 1e-3);
  for (const auto quantity : {Quantity::worn_volume, Quantity::worn_radius, Quantity::distance_to_limit}) {
    ASSERT_EQ(wear.comparison.count(quantity), 1u);
    EXPECT_LT(wear.comparison.at(quantity).size(), wear.comparison.at(quantity).tolerance) << name_of(quantity);
    EXPECT_FALSE(wear.comparison.at(quantity).bar);
  }
}

// Wear that is left while it still goes on has a bar for what is left: without it, what lacks would be no error.
TEST(WearProof, StoppingIsPartOfTheBar) {
  const auto text = wearing_text("  set Coefficient = 1e-12\n  set Until = 1e-4\n");
  const auto prepared =
      prepared_case(replace(text, "Tolerance = 1e-3", "Tolerance = 1e-3\n  set Rings per radius = 16"));
  const auto wear = proved(prepared, Proof::bars);
  ASSERT_EQ(wear.failure, "");
  ASSERT_EQ(wear.fe.course.end, fem::WearEnd::rate);
  ASSERT_TRUE(wear.ends_in_limit());
  const auto& volume = wear.comparison.at(Quantity::worn_volume);
  const auto share = std::find_if(volume.bar->shares.begin(), volume.bar->shares.end(),
                                  [](const ErrorShare& s) { return s.source == ErrorSource::cycles; });
  ASSERT_NE(share, volume.bar->shares.end());
  EXPECT_GT(share->estimate, 1e-5);
  // As many further cycles at the rate of the last jump.
  const auto &last = wear.fe.course.curve.back(), &before = *(wear.fe.course.curve.end() - 2);
  const double rate = (last.volume - before.volume) / (last.cycles - before.cycles);
  EXPECT_NEAR(share->estimate, rate * last.cycles * prepared.fem.units.volume() / wear.limits.shakedown.volume,
              1e-9 * share->estimate);
  EXPECT_LT(std::abs(volume.difference.value()), volume.bar->total());
}

// An indenter that is worn too deep already cannot end there.
TEST(WearProof, WhereTheIndenterIsWornDeeperThanTheLimitNothingIsCompared) {
  const ScratchFolder folder;
  const auto end_of = [&](const std::string& rows) {
    const auto table = folder.write("worn.csv", "r [mm],f [mm]\n" + rows);
    return proved(
        wearing_case("  set Coefficient = 1e-12\n  set Cycles = 1e4\n  set Profile = " + table.string() + "\n"),
        Proof::none);
  };
  EXPECT_TRUE(end_of("0,0\n0.6,0.018\n0.7,0.0255\n0.8,0.032\n2,0.2\n").limits.reached);
  EXPECT_FALSE(end_of("0,0\n0.3,0.006\n0.4,0.008\n2,0.2\n").limits.reached) << "inside the stick zone";
}

// In phase, with k = 3 mu Dd/(2 u_x0) = 1: what touches sticks, and the work of friction is less than its error.
// Nothing of what its cycles would wear is compared.
TEST(WearProof, WhereNoSlipIsProvedNothingIsCompared) {
  auto prepared = wearing_case("  set Coefficient = 1e-12\n  set Cycles = 1\n", "set Phase = 0");
  const auto proved_with = [&prepared](double friction_bar) {
    const auto mdr = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
    ProvedAnswer unworn{};
    unworn.fe = compute_case(prepared.fem, prepared.fem.resolution, shared_bodies());
    const double work = unworn.fe.cycle.value().value(Quantity::friction_work) / unworn.fe.cycle->sliding_work;
    unworn.budget[Quantity::friction_work].add(ErrorSource::rings, friction_bar * work);
    return prove_wear(prepared, mdr, unworn, Proof::none, shared_bodies());
  };
  const auto slips = proved_with(0.9), sticks = proved_with(1.1);
  EXPECT_TRUE(slips.slip_is_proved);
  EXPECT_EQ(slips.comparison.count(Quantity::worn_volume), 1u);
  EXPECT_FALSE(sticks.slip_is_proved);
  EXPECT_TRUE(sticks.comparison.empty());
}

// In phase with k = 2: nothing slips, in either method, and that is compared.
TEST(WearProof, WhereAllThatTouchesSticksNothingWears) {
  auto text = replace(wearing_text("  set Coefficient = 1e-12\n"), "Phase = 90", "Phase = 0");
  text = replace(text, "Tangential amplitude = 3e-5", "Tangential amplitude = 7.5e-6");
  const auto prepared =
      prepared_case(replace(text, "Tolerance = 1e-3", "Tolerance = 1e-3\n  set Rings per radius = 16"));
  const auto mdr = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
  ProvedAnswer unworn{};
  unworn.fe = compute_case(prepared.fem, prepared.fem.resolution, shared_bodies());
  unworn.budget[Quantity::friction_work].add(ErrorSource::rings, 1);
  const auto wear = prove_wear(prepared, mdr, unworn, Proof::bars, shared_bodies());
  ASSERT_EQ(wear.failure, "");
  EXPECT_FALSE(wear.slip_is_proved);
  EXPECT_TRUE(wear.sticks_throughout);
  EXPECT_EQ(wear.kinetics->curve.back().volume, 0);
  EXPECT_EQ(wear.springs_error, 0);
  const auto& volume = wear.comparison.at(Quantity::worn_volume);
  EXPECT_LT(std::abs(volume.difference.value()), 1e-3);
  EXPECT_LT(std::abs(volume.difference.value()), volume.bar.value().total());
}

// After few cycles there is no limit yet, and the springs' volume is what it is compared with.
TEST(WearProof, OnItsWayIsComparedWithTheSprings) {
  const auto wear = proved(wearing_case("  set Coefficient = 1e-12\n  set Cycles = 1e5\n"), Proof::none);
  ASSERT_EQ(wear.failure, "");
  EXPECT_FALSE(wear.ends_in_limit());
  EXPECT_LT(wear.springs_error.value(), 3e-3);
  ASSERT_EQ(wear.comparison.size(), 1u);
  EXPECT_LT(std::abs(wear.comparison.at(Quantity::worn_volume).difference.value()), 3e-3);
  EXPECT_LT(wear.largest_springs_difference.value(), 3e-3);
  EXPECT_GT(wear.kinetics->curve.back().volume, 1e-3 * wear.limits.shakedown.volume);
}

// What a bar takes the volume to depend on the stick radius by, 5/2 V/(a - c), is reached at c = a and not exceeded.
TEST(WearProof, VolumeVanishesLikeThePowerFiveHalvesOfTheSlipZone) {
  for (const auto& profile : {mdr::parabola(1), mdr::cone(1)}) {
    const auto power = [&](double c) {
      const auto volume = [&](double radius) {
        return mdr::worn_volume(mdr::limiting_profile(profile, radius, mdr::transform(profile, 1)));
      };
      const double step = 1e-3 * (1 - c);
      return (volume(c - step) - volume(c + step)) / (2 * step) * (1 - c) / volume(c);
    };
    EXPECT_NEAR(power(0.99), 2.5, 0.02);
    for (const double c : {0.2, 0.4, 0.6, 0.8, 0.9}) EXPECT_LT(power(c), 2.5) << c;
  }
}

}  // namespace
}  // namespace fretval
