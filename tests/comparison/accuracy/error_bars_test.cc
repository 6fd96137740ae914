#include "comparison/accuracy/error_bars.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/motion/stepped_stiffening.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"
#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/some_cycle.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

constexpr auto first_slip_radius = Quantity::stick_radius_first_slip,
               shakedown_radius = Quantity::stick_radius_shakedown;

ErrorBudget bars_of(const PreparedCase& prepared, const FakeNumerics& numerics, Borders borders = Borders::left_out,
                    const std::optional<Focus>& focus = {}) {
  Tracks tracks{prepared.fem.resolution, {}};
  if (focus) (tracks.focused[shakedown_radius] = tracks.base).focus = focus;
  Computations computed(prepared.fem.units, fake_compute(prepared, numerics), 1);
  computed.compute(needed_for_bars(tracks, needs_of(prepared.fem)));
  return error_bars(prepared, tracks, computed, borders);
}

PreparedCase prepared_of(const std::string& name) {
  return prepare({suite_case(name, 1e-3)}).front();
}

TEST(ErrorBars, KnowWhatMovesTheIndenterStepByStep) {
  const auto cosines = prepared_of("parabola-solid-90").fem;
  EXPECT_FALSE(needs_of(cosines).moves_by_steps);
  auto force = cosines, path = cosines;
  force.motion.tangential_force = true;
  EXPECT_TRUE(needs_of(force).moves_by_steps);
  path.motion.path = fem::SampledPath{{0, 3, 2 * fem::pi}, {1, 1.2, 1}, {0, 0.1, 0}, 1, 0, true};
  EXPECT_TRUE(needs_of(path).moves_by_steps);
}

// Branches of 1/252 and 1/158 of a period: what steps make of an oscillating force is known where all steps say the
// same.
TEST(ErrorBars, UnderForcesKnowWhatStepsMakeOfShortBranches) {
  auto prepared = prepared_of("parabola-solid-90");
  auto& fem = prepared.fem;
  fem.relaxation = {1, {16, 4.5}, {2 * fem::pi / 252, 2 * fem::pi / 158}, 0};
  fem.resolution.steps_per_cycle = 32;
  const auto width = [&](Quantity quantity) {
    Tracks tracks{fem.resolution, {}};
    const auto compute = [&](const Resolution& r) {
      auto answer = FakeNumerics{0, 0}(fem, r);
      answer.indentation_max = fem.units.depth;
      answer.tangential_amplitude = fem.units.depth;
      answer.normal.indentation = Eigen::Vector3d(1, 0.75, 0.5);
      return answer;
    };
    Computations computed(fem.units, compute, 1);
    computed.compute(needed_for_bars(tracks, needs_of(fem)));
    const auto bars = error_bars(prepared, tracks, computed, Borders::left_out);
    return bars.count(quantity) == 0 ? -1 : bars.at(quantity).total();
  };
  EXPECT_LT(width(Quantity::tangential_amplitude), 1e-6);
  EXPECT_LT(width(Quantity::indentation_max), 1e-6);
  fem.motion.tangential_force = fem.motion.normal_force = true;
  const double off = std::abs(
      fem::stiffening_at(fem.relaxation, 1) / fem::stepped_stiffening_at(fem.relaxation, 1, 2 * fem::pi / 32) - 1.0);
  EXPECT_GT(off, 4e-3);
  EXPECT_NEAR(width(Quantity::tangential_amplitude), off, 1e-6);
  for (const auto quantity : {Quantity::indentation_max, Quantity::contact_radius_max})
    EXPECT_NEAR(width(quantity), off / 4, 1e-6);  // a quarter of the depth oscillates
}

TEST(ErrorBars, KnowAMotionWithoutAPeriod) {
  EXPECT_TRUE(needs_of(prepared_of("parabola-elastic-free").fem).without_period);
  auto fem = prepared_of("parabola-elastic-90").fem;
  EXPECT_FALSE(needs_of(fem).without_period);
  fem.without_short_cycle = mdr::HarmonicMotion{};
  EXPECT_TRUE(needs_of(fem).without_period);
}

TEST(ErrorBars, KnowALayerThatSlides) {
  auto fem = prepared_of("parabola-elastic-90").fem;
  EXPECT_FALSE(needs_of(fem).stretches || needs_of(fem).ends);
  fem.solid = Solid{1, std::nullopt, true};
  EXPECT_TRUE(needs_of(fem).ends);
  EXPECT_TRUE(needs_of(fem).stretches);
  fem.solid->slides_on_base = false;
  EXPECT_FALSE(needs_of(fem).stretches);
  fem.solid = Solid{1, 5.0, true};  // which ends where the case says
  EXPECT_FALSE(needs_of(fem).stretches);
}

// It is the same at all resolutions, so that no difference of two shows it.
TEST(ErrorBars, HaveWhatAHalfSpaceLeavesOpenOfTheEdges) {
  const auto prepared = prepared_of("parabola-elastic-90");
  const auto& resolution = prepared.fem.resolution;
  const FakeNumerics numerics{30, 2};
  Computations computed(
      prepared.fem.units,
      [&](const Resolution& r) {
        auto answer = numerics(prepared.fem, r);
        answer.contact_radius_calibration = 1e-5 * prepared.fem.units.length;
        return answer;
      },
      1);
  computed.compute(needed_for_bars({resolution, {}}, needs_of(prepared.fem)));
  const auto bars = error_bars(prepared, {resolution, {}}, computed, Borders::left_out);
  EXPECT_NEAR(bars.at(Quantity::contact_radius_max).total(), 1e-5, 1e-15);
}

/// Bars of a cycle whose steps put the largest force off by 1e-3 N and hide it by 5e-4 N, the energy of friction by
/// -3e-8 J at the finest resolution and by twice that at all others. to_be_seen: whether the energies that were
/// computed show it.
ErrorBudget bars_of_cycle(const PreparedCase& prepared, bool to_be_seen) {
  const auto& resolution = prepared.fem.resolution;
  Computations computed(
      prepared.fem.units,
      [&](const Resolution& r) {
        auto answer = FakeNumerics{30, 2}(prepared.fem, r);
        const double off = r == resolution ? -3e-8 : -6e-8;
        answer.cycle = some_cycle({0.5, 0, 2e-5 + (to_be_seen ? off : 0), 0, 2e-5});
        answer.cycle->off_by_steps = {{Quantity::tangential_force_max, 1e-3}, {Quantity::friction_work, off}};
        answer.cycle->between_steps = {{Quantity::tangential_force_max, 5e-4}};
        return answer;
      },
      1);
  computed.compute(needed_for_bars({resolution, {}}, needs_of(prepared.fem)));
  return error_bars(prepared, {resolution, {}}, computed, Borders::left_out);
}

// Energies are over what sliding would cost, 1e-4 J here, and the largest force over itself.
TEST(ErrorBars, HaveWhatStepsPutACycleOffBy) {
  const auto bars = bars_of_cycle(prepared_of("parabola-elastic-90"), true);
  const auto& of_force = bars.at(Quantity::tangential_force_max);
  EXPECT_NEAR(of_force.total(), 2e-3 + 1e-3, 1e-12);
  EXPECT_EQ(of_force.largest()->source, ErrorSource::time_step);
  EXPECT_NEAR(bars.at(Quantity::friction_work).total(), 3e-4, 1e-12) << "differences of resolutions are without it";
  EXPECT_EQ(bars.at(Quantity::tangential_force_mean).total(), 0);
}

// Of a body with memory what is locked in fades: it is a bound, and differences are taken as they are.
TEST(ErrorBars, OfABodyWithMemoryHaveItAsABound) {
  const auto prepared = prepared_of("parabola-solid-90");
  EXPECT_NEAR(bars_of_cycle(prepared, false).at(Quantity::friction_work).total(), 3e-4, 1e-12);
  EXPECT_GT(bars_of_cycle(prepared, true).at(Quantity::friction_work).total(), 5e-4);
}

// In logarithms nothing is infinitely far from any energy; 2e-5 J that are 3e-5 off may be nothing.
TEST(ErrorBars, OfTheWholeValueLeaveOpenWhetherThereIsAny) {
  const auto prepared = prepared_of("parabola-solid-90");
  const auto& resolution = prepared.fem.resolution;
  const auto bar_with = [&](double off) {
    Computations computed(
        prepared.fem.units,
        [&](const Resolution& r) {
          auto answer = FakeNumerics{30, 2}(prepared.fem, r);
          answer.cycle = some_cycle({0.5, 0, 2e-5, 2e-5, 2e-5});
          answer.cycle->off_by_steps = {{Quantity::bulk_work, off}};
          return answer;
        },
        1);
    computed.compute(needed_for_bars({resolution, {}}, needs_of(prepared.fem)));
    return error_bars(prepared, {resolution, {}}, computed, Borders::left_out).at(Quantity::bulk_work).total();
  };
  EXPECT_NEAR(bar_with(1e-5), 0.5, 1e-9);
  EXPECT_TRUE(std::isinf(bar_with(3e-5)));
}

TEST(ErrorBars, CoverTheErrorsThatAreThere) {
  for (const char* name : {"parabola-elastic-90", "parabola-solid-90", "parabola-elastic-free"})
    for (const auto& focus : {std::optional<Focus>(), std::optional(Focus{0, 0.25, 0.01})}) {
      const auto prepared = prepared_of(name);
      const FakeNumerics numerics{30, 2};
      const double error = numerics.error(prepared.fem.resolution);
      const auto bars = bars_of(prepared, numerics, Borders::left_out, focus);
      EXPECT_EQ(bars.size(), 4U) << name;
      for (const auto quantity : {first_slip_radius, shakedown_radius}) {
        EXPECT_GT(bars.at(quantity).total(), error) << name;
        EXPECT_LT(bars.at(quantity).total(), 3 * error) << name;
      }
      EXPECT_EQ(bars.at(Quantity::contact_radius_max).total(), 0) << name << ": which is exact";
    }
}

// A bar of more than half of a stick radius leaves open whether anything sticks.
TEST(ErrorBars, OfASmallStickZoneReachToNothing) {
  const auto prepared = prepared_of("parabola-elastic-90");
  const double rings = prepared.fem.resolution.elements_per_radius, to_error = rings * rings * rings;
  const double resolved = bars_of(prepared, {0.002 * to_error, 0, 0.008}).at(shakedown_radius).total(),
               open = bars_of(prepared, {0.004 * to_error, 0, 0.006}).at(shakedown_radius).total();
  EXPECT_LT(resolved, 0.005);
  EXPECT_GT(open, 0.01);
}

// Of a creep that no fewer cycles show nothing is known.
TEST(ErrorBars, OfCreepThatCannotBeRefinedAreInfinite) {
  const auto prepared = prepared_of("parabola-elastic-free");
  const Tracks tracks{prepared.fem.resolution, {}};
  const auto compute = [&](const Resolution& r) -> FeAnswer {
    if (2 * r.n_creep_cycles == tracks.base.n_creep_cycles) throw fem::SolverError("too few cycles");
    return FakeNumerics{30, 2}(prepared.fem, r);
  };
  Computations computed(prepared.fem.units, compute, 1);
  computed.compute(needed_for_bars(tracks, needs_of(prepared.fem)));
  const auto bars = error_bars(prepared, tracks, computed, Borders::left_out);
  for (const auto quantity : {first_slip_radius, shakedown_radius}) EXPECT_TRUE(std::isinf(bars.at(quantity).total()));
}

// Nothing is known of the radius but that a depth within its error decides on it.
TEST(ErrorBars, CarryADepthThatMayBeNone) {
  const auto prepared = prepared_of("parabola-elastic-90");
  const double rings = prepared.fem.resolution.elements_per_radius, to_error = rings * rings * rings;
  const FakeNumerics open{0, 0, 0.5, 0.5, 1e-3, 2e-3 * to_error}, clear{0, 0, 0.5, 0.5, 1e-1, 2e-3 * to_error};
  EXPECT_GE(bars_of(prepared, open, Borders::carried).at(shakedown_radius).total(), 0.5);
  EXPECT_LT(bars_of(prepared, open, Borders::left_out).at(shakedown_radius).total(), 0.1);
  EXPECT_LT(bars_of(prepared, clear, Borders::carried).at(shakedown_radius).total(), 0.1);
}

// Where a few rings inside a flat face stick by no more than the error of their depth, all of the face may.
TEST(ErrorBars, OfAZoneInsideAFlatFaceReachToItsEdge) {
  const auto prepared = prepared_of("rounded-flat-elastic-90");
  const double rings = prepared.fem.resolution.elements_per_radius, to_error = rings * rings * rings,
               face = prepared.input.indenter.flat_radius / prepared.fem.units.length;
  ASSERT_GT(face, 0.3);
  const FakeNumerics open{0, 0, 0.03, 0.03, 1e-3, 2e-3 * to_error}, clear{0, 0, 0.03, 0.03, 1e-1, 2e-3 * to_error};
  for (const auto quantity : {first_slip_radius, shakedown_radius}) {
    EXPECT_GE(bars_of(prepared, open, Borders::carried).at(quantity).total(), face - 0.03);
    EXPECT_LT(bars_of(prepared, clear, Borders::carried).at(quantity).total(), 0.1);
  }
}

// Where it comes to touch nothing is in contact at rest.
TEST(ErrorBars, OfAPassAreThoseOfTheStickRadiiThatItHas) {
  auto prepared = prepared_of("parabola-elastic-90");
  for (const auto& [kind, has_first_slip] : {std::pair{MotionKind::pass, true}, {MotionKind::pass_from_touch, false}}) {
    prepared.fem.motion_kind = kind;
    const auto bars = bars_of(prepared, {30, 2}, Borders::carried);
    EXPECT_EQ(bars.count(first_slip_radius) > 0, has_first_slip);
    EXPECT_EQ(bars.count(shakedown_radius), 0U);
    EXPECT_EQ(bars.count(Quantity::contact_radius_max), 1U);
  }
}

// Depths fall by 2 over the contact radius, so that 0.04 of depth are 0.02 of radius to either side.
TEST(ErrorBars, HaveWhatACycleThatStandsForAMotionLeavesOpen) {
  auto prepared = prepared_of("parabola-elastic-90");
  const auto total = [&](Quantity quantity) { return bars_of(prepared, {0, 0}).at(quantity).total(); };
  prepared.fem.error_of_normal = 0.01;
  EXPECT_EQ(total(Quantity::normal_force_max), 0) << "a cycle of its own";
  prepared.fem.error_of_demand = 0.04;
  EXPECT_NEAR(total(Quantity::normal_force_max), 0.02, 1e-12);
  EXPECT_EQ(total(Quantity::contact_radius_max), 0) << "prescribed with the indentation";
  for (const auto quantity : {first_slip_radius, shakedown_radius}) EXPECT_NEAR(total(quantity), 0.04, 1e-12);
  EXPECT_EQ(bars_of(prepared, {0, 0}).at(shakedown_radius).largest()->source, ErrorSource::creep);
  prepared.fem.motion.normal_force = true;
  EXPECT_NEAR(total(Quantity::contact_radius_max), 0.02, 1e-12);
  EXPECT_EQ(total(Quantity::normal_force_max), 0) << "prescribed";
}

// Rings stick up to 0.5 a, the worn edge is at 0.6 a, and slip in between is within or beyond its bar.
TEST(ErrorBars, OfAWornProfileReachToItsEdgeWhereItsSlipMayBeNone) {
  auto prepared = prepared_of("parabola-elastic-90");
  prepared.fem.kind = ContactKind::worn;
  prepared.fem.worn_edge = {0.6, 0.7};
  const auto total = [&](double slip) {
    Computations computed(
        prepared.fem.units,
        [&](const Resolution& r) {
          auto answer = FakeNumerics{0, 0}(prepared.fem, r);
          answer.of_kind = NoWearEvidence{slip + 1e-2 * r.elements_per_radius, 0, 1, 1};
          return answer;
        },
        1);
    const Tracks tracks{prepared.fem.resolution, {}};
    computed.compute(needed_for_bars(tracks, needs_of(prepared.fem)));
    return error_bars(prepared, tracks, computed, Borders::left_out).at(shakedown_radius).total();
  };
  EXPECT_NEAR(total(0), 0.1, 1e-12);
  EXPECT_EQ(total(1e3), 0);
}

// They are the same number, whose error either may hide.
TEST(ErrorBars, OfAnUnlockedPhaseTakeTheCreepOfEitherRadiusForBoth) {
  FakeNumerics creeping{0, 0};
  creeping.creep_error = 0.1;
  const auto bars = [&](const char* name) { return bars_of(prepared_of(name), creeping); };
  const auto free = bars("parabola-elastic-free"), locked = bars("parabola-elastic-90");
  const double error = 0.1 / prepared_of("parabola-elastic-free").fem.resolution.n_creep_cycles;
  for (const auto quantity : {first_slip_radius, shakedown_radius})
    EXPECT_NEAR(free.at(quantity).total(), 1.5 * error, 1e-12);
  EXPECT_EQ(locked.at(first_slip_radius).total(), 0);
}

TEST(ErrorBars, OfAnUnlockedPhaseReachFromOneRadiusToTheOther) {
  const FakeNumerics apart{0, 0, 0.5, 0.52};
  const auto free = bars_of(prepared_of("parabola-elastic-free"), apart),
             locked = bars_of(prepared_of("parabola-elastic-90"), apart);
  for (const auto quantity : {first_slip_radius, shakedown_radius}) {
    EXPECT_NEAR(free.at(quantity).total(), 0.02, 1e-12);
    EXPECT_EQ(locked.at(quantity).total(), 0);
  }
  auto of_two = prepared_of("parabola-elastic-free");
  of_two.fem.motion.tangential.push_back({0.1, 2, 0});
  EXPECT_EQ(bars_of(of_two, apart).at(shakedown_radius).total(), 0) << "which need not be equal";
}

// While an unlocked phase drifts, rings slip on the way that would not.
TEST(ErrorBars, OfNoFirstSlipZoneReachToTheShakedownRadiusWhereThePhaseDrifts) {
  const FakeNumerics no_first_slip{0, 0, 0, 0.3};
  const auto bar = [&](const char* name) {
    return bars_of(prepared_of(name), no_first_slip, Borders::carried).at(first_slip_radius).total();
  };
  EXPECT_GE(bar("parabola-elastic-free"), 0.3);
  EXPECT_LT(bar("parabola-elastic-90"), 0.1);
}

// What is known of the shakedown radius no better is part of how far the first-slip radius may be off.
TEST(ErrorBars, OfNoFirstSlipZoneReachBeyondTheShakedownRadiusByItsBar) {
  const auto prepared = prepared_of("parabola-elastic-free");
  const FakeNumerics no_first_slip{30, 2, 0, 0.3};
  const auto bars = bars_of(prepared, no_first_slip, Borders::carried);
  const double shakedown_bar = bars.at(shakedown_radius).total();
  ASSERT_GT(shakedown_bar, 1e-5);
  EXPECT_NEAR(bars.at(first_slip_radius).total(), 0.3 + no_first_slip.error(prepared.fem.resolution) + shakedown_bar,
              1e-12);
}

// Differences between resolutions compare steps of one and two.
TEST(ErrorBars, KnowABranchThatRelaxesWithinTwoSteps) {
  auto fem = prepared_of("parabola-solid-90").fem;
  const double step = 2 * fem::pi / fem.steps_per_cycle();
  fem.relaxation.times = {2.1 * step};
  EXPECT_FALSE(needs_of(fem).has_short_branch);
  fem.relaxation.times = {2.1 * step, 1.5 * step};
  EXPECT_TRUE(needs_of(fem).has_short_branch);
}

}  // namespace
}  // namespace fretval
