#include "comparison/accuracy/surface_wear_proof.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/comparison/computed_case.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::surface_wear_proof_test {
namespace {

/// As if it had been computed unworn.
ProvedSurfaceWear proved(Proof proof) {
  const auto prepared = wearing_in_a_circle();
  ProvedAnswer unworn{};
  unworn.fe.stick_radius_shakedown = 0.8 * prepared.fem.units.length;
  return prove_surface_wear(prepared, mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)), unworn, proof,
                            shared_bodies());
}

TEST(SurfaceWearProof, WithoutAProofHasNoBars) {
  const auto wear = proved(Proof::none);
  EXPECT_TRUE(wear.failure.empty()) << wear.failure;
  EXPECT_FALSE(wear.is_proved);
  EXPECT_TRUE(wear.radius.shares.empty());
  EXPECT_EQ(wear.cost.computations, 1);
}

TEST(SurfaceWearProof, BarsHaveAShareOfEachSource) {
  const auto wear = proved(Proof::tolerance);
  ASSERT_TRUE(wear.is_proved) << wear.failure;
  EXPECT_EQ(wear.cost.computations, 5);
  const auto has = [](const ErrorBar& bar, ErrorSource source) {
    return std::any_of(bar.shares.begin(), bar.shares.end(), [&](const auto& share) { return share.source == source; });
  };
  for (const auto source : {ErrorSource::rings, ErrorSource::time_step, ErrorSource::angles, ErrorSource::wear_jump}) {
    EXPECT_TRUE(has(wear.radius, source));
    EXPECT_TRUE(has(wear.volume, source));
  }
  EXPECT_GE(wear.radius.total(), wear.fe.sticks.uncertainty) << "a ring";
  EXPECT_GT(wear.volume.total(), 0);
  EXPECT_NEAR(wear.limit.stick_radius, 0.8563e-3, 1e-6) << "sqrt(1 - 0.8/3)";
}

}  // namespace
}  // namespace fretval::surface_wear_proof_test
