#include "comparison/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval {
namespace {

constexpr double a = 1e-3;

MdrAnswer mdr_with(std::optional<double> stick) {
  return {1.5, a, stick, stick, std::nullopt, 2.0};
}

FeAnswer fe_with(std::optional<double> stick) {
  FeAnswer fe{};
  fe.contact_radius_max = a;
  fe.stick_radius_first_slip = stick;
  fe.stick_radius_shakedown = stick;
  fe.normal_force_max = 2.0;
  return fe;
}

bool agree(std::optional<double> mdr, std::optional<double> fe) {
  return passes(compare(mdr_with(mdr), fe_with(fe), a, tolerances_of(1e-3)));
}

TEST(Verdict, ComparesStickRadiiOverTheContactRadius) {
  EXPECT_TRUE(agree(0.5 * a, 0.5009 * a));
  EXPECT_FALSE(agree(0.5 * a, 0.5011 * a));
  EXPECT_FALSE(agree(0.5 * a, 0.4989 * a));
}

TEST(Verdict, WidensForSmallStickZonesOnly) {
  EXPECT_TRUE(agree(0.05 * a, 0.0519 * a));
  EXPECT_FALSE(agree(0.05 * a, 0.0521 * a));
  EXPECT_FALSE(agree(0.1 * a, 0.1011 * a));
}

TEST(Verdict, DemandsThatBothSayThatNothingSticks) {
  EXPECT_TRUE(agree(std::nullopt, std::nullopt));
  EXPECT_FALSE(agree(std::nullopt, 0.01 * a));
  EXPECT_FALSE(agree(0.1 * a, std::nullopt));
}

TEST(Verdict, HoldsRadiusAndForceToATenth) {
  auto fe = fe_with(0.5 * a);
  fe.contact_radius_max = a * (1 + 1.1e-4);
  EXPECT_FALSE(passes(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3))));
  fe = fe_with(0.5 * a);
  fe.normal_force_max = 2.0 * (1 - 1.1e-4);
  EXPECT_FALSE(passes(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3))));
}

TEST(Verdict, FailsOnNotANumber) {
  EXPECT_FALSE(agree(0.5 * a, std::nan("")));
}

TEST(Verdict, HoldsTheLimitingStateToNoSlipAndNoPressure) {
  auto fe = fe_with(0.5 * a);
  fe.contact_radius_max.reset();
  fe.no_wear = NoWearEvidence{1e-5, 1e-5, 1};
  const auto judge = [&] { return passes(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3))); };
  EXPECT_TRUE(judge());
  fe.no_wear = NoWearEvidence{2e-3, 1e-5, 1};
  EXPECT_FALSE(judge());
  fe.no_wear = NoWearEvidence{1e-5, 2e-3, 1};
  EXPECT_FALSE(judge());
  fe.no_wear = NoWearEvidence{1e-5, 1e-5, 1.002};
  EXPECT_FALSE(judge());
}

}  // namespace
}  // namespace fretval
