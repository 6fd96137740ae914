#include "comparison/accuracy/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_answer.h"
#include "fem/support/solver_error.h"
#include "mdr/stick/stick_radius.h"
#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

struct Studied {
  PreparedCase prepared;
  ProvedAnswer result;
  double exact;  ///< shakedown radius over the unworn contact radius

  [[nodiscard]] double shakedown() const {
    return result.fe.stick_radius_shakedown.value() / prepared.fem.units.length;
  }
};

Studied study(const Case& input, Proof proof = Proof::tolerance) {
  Studied studied{prepare({input}).front(), {}, 0};
  BodyStore bodies;
  studied.result = prove(studied.prepared, proof, bodies);
  const auto& mdr = studied.prepared.mdr;
  const auto radii = mdr::stick_radii(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.motion);
  studied.exact = radii.shakedown.value() / studied.prepared.fem.units.length;
  return studied;
}

TEST(ProofSlow, FocusesOnASmallStickZone) {
  const auto studied = study(suite_case("small-stick-parabola", 1e-3));
  ASSERT_EQ(studied.result.failure, "");
  EXPECT_NEAR(studied.exact, 0.02, 1e-9);
  EXPECT_EQ(studied.result.focus.count(Quantity::stick_radius_shakedown), 1U);
  EXPECT_NEAR(studied.shakedown(), studied.exact, 0.05 * studied.exact);
}

TEST(ProofSlow, FocusesOnANarrowSlipAnnulus) {
  const auto studied = study(suite_case("narrow-slip-parabola", 1e-3));
  ASSERT_EQ(studied.result.failure, "");
  EXPECT_NEAR(studied.exact, 0.999, 1e-9);
  EXPECT_EQ(studied.result.focus.count(Quantity::stick_radius_shakedown), 1U);
  EXPECT_NEAR(studied.shakedown(), studied.exact, 0.05 * (1 - studied.exact));
}

TEST(ProofSlow, DoesNotFocusWhereRingsResolveTheZones) {
  const auto studied = study(suite_case("parabola-elastic-90", 1e-3));
  EXPECT_TRUE(studied.result.focus.empty());
  EXPECT_NEAR(studied.shakedown(), studied.exact, 1e-3);
}

// At 24 rings the force was 5.6e-5 off under a bar of 2.5e-5: a worn profile on 6 rings tells nothing of finer ones.
TEST(ProofSlow, ForceOfAWornProfileIsWithinItsBar) {
  const auto cases = read_case_file(std::filesystem::path(FRETVAL_SOURCE_DIR) / "cases/figure4/figure4-parabola.prm");
  const auto& input = cases.at(3);
  EXPECT_EQ(input.worn_stick_ratio, 0.4);
  const auto studied = study(input);
  const auto& mdr = studied.prepared.mdr;
  const double exact = mdr_answer(mdr, mdr_normal_response(mdr)).normal_force_max.value();
  EXPECT_NEAR(studied.result.fe.normal_force_max / exact, 1,
              studied.result.budget.at(Quantity::normal_force_max).total());
}

// Both zones end next to the edge of the face, where pressures are singular. Finer rings with a node at the contact
// radius hardly change what is read: 5.2e-3 off at 32 rings, under 4.5e-4 of all other sources.
TEST(ProofSlow, EdgeNextToASharpOneIsWithinItsBar) {
  const auto studied = study(read_case(R"(
subsection Indenter
  set Shape = truncated sphere
  set Radius = 7.50523e-05
  set Flat radius = 4.46114e-06
end
subsection Elastomer
  set Rheology = elastic
  set Relaxed shear modulus = 1e6
end
subsection Friction
  set Coefficient = 0.451349
end
subsection Motion
  set Indentation = 1.02971e-06
  set Normal amplitude = 0
  set Normal frequency = 10
  set Phase = -90.9202
  set Tangential amplitude = 4.929955e-07
  set Tangential frequency = 10
  set Tangential harmonics = 8.69132e-08, 30, 49.8452
end
subsection Accuracy
  set Tolerance = 0.01
  set Rings per radius = 32
  set Steps per cycle = 32
end
)"),
                             Proof::bars);
  const auto& bar = studied.result.budget.at(Quantity::stick_radius_shakedown);
  const auto edge = std::find_if(bar.shares.begin(), bar.shares.end(),
                                 [](const ErrorShare& share) { return share.source == ErrorSource::edge; });
  const double error = std::abs(studied.shakedown() - studied.exact);
  EXPECT_LT(error, bar.total());
  EXPECT_GT(error, bar.total() - edge->estimate);
}

ProvedAnswer fake_study(const PreparedCase& prepared, const FakeNumerics& numerics, Proof proof = Proof::tolerance) {
  return prove(prepared, proof, fake_compute(prepared, numerics));
}

// Hertz: nothing moves, nothing slips, and there is no slip annulus to look for at the edge.
TEST(Proof, LooksForNoSlipWhereNothingMoves) {
  Case input = read_case(elastic_case());
  input.motion.normal_amplitude = input.motion.tangential_amplitude = 0;
  input.tolerance = 1e-3;
  BodyStore bodies;
  const auto result = prove(prepare({input}).front(), Proof::tolerance, bodies);
  EXPECT_EQ(result.failure, "");
  EXPECT_NEAR(result.fe.stick_radius_shakedown.value() / result.fe.contact_radius_max.value(), 1, 1e-4);
  for (const auto& [quantity, bar] : result.budget) EXPECT_LT(bar.total(), 1e-3) << name_of(quantity);
}

// Mindlin and Deresiewicz: the energy of a loop between +-u_x0 under a constant normal force.
TEST(Proof, RefinesForACycleWithATolerance) {
  Case input = read_case(elastic_case());
  input.motion.normal_amplitude = 0;
  input.tolerance = 1e-2;
  const auto proved_to = [&](std::optional<double> cycle_tolerance) {
    input.cycle_tolerance = cycle_tolerance;
    BodyStore bodies;
    return prove(prepare({input}).front(), Proof::tolerance, bodies);
  };
  const double d = input.motion.indentation, mu = input.friction_coefficient,
               x = input.motion.tangential_amplitude / (1.5 * mu * d),
               over_sliding = 2 / x * (x - 0.4 * (1 - std::pow(1 - x, 2.5))) - (1 - std::pow(1 - x, 1.5));
  const auto bar_of = [&](const ProvedAnswer& answer) {
    const double bar = answer.budget.at(Quantity::friction_work).total();
    EXPECT_NEAR(answer.fe.cycle->value(Quantity::friction_work) / answer.fe.cycle->sliding_work, over_sliding, bar);
    return bar;
  };
  EXPECT_GT(bar_of(proved_to({})), 1e-4);
  EXPECT_LE(bar_of(proved_to(1e-3)), 1e-4);
}

TEST(Proof, GoesAsFarAsItIsAsked) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const FakeNumerics coarse{100, 0};
  const auto answer = fake_study(prepared, coarse, Proof::none);
  EXPECT_EQ(answer.cost.computations, 1);
  EXPECT_TRUE(answer.budget.empty());
  EXPECT_GT(fake_study(prepared, coarse).n_refinements, 0);
}

// Where finer rings fail, what was proved before stands, with bars that are wider than asked for.
TEST(Proof, TakesARefinementBackThatFails) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const FakeNumerics coarse{100, 0};
  const unsigned start = prepared.fem.resolution.elements_per_radius;
  const auto answer = prove(prepared, Proof::tolerance, {[&](const Resolution& r) {
                              if (r.elements_per_radius > start) throw fem::SolverError("out of rings");
                              return coarse(prepared.fem, r);
                            }});
  EXPECT_EQ(answer.failure, "");
  EXPECT_EQ(answer.resolution.elements_per_radius, start);
  EXPECT_GT(answer.budget.at(Quantity::stick_radius_shakedown).total(), 1e-3);
}

TEST(Proof, NamesAFailureOfTheNumerics) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  for (const auto proof : {Proof::none, Proof::bars, Proof::tolerance}) {
    const auto answer =
        prove(prepared, proof, {[](const Resolution&) -> FeAnswer { throw fem::SolverError("singular"); }});
    EXPECT_EQ(answer.failure, "singular") << name_of(proof);
  }
}

TEST(Proof, KeepsWhatIsFineEnough) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto result = fake_study(prepared, {0.1, 0.01});
  EXPECT_EQ(result.n_refinements, 0);
  EXPECT_EQ(result.resolution.elements_per_radius, prepared.fem.resolution.elements_per_radius);
  EXPECT_LE(result.budget.at(Quantity::stick_radius_shakedown).total(), 1e-3);
}

// What MDR's springs may be off by is a part of the tolerance; half of it is left in any case.
TEST(Proof, LeavesTheReferenceItsPartOfATolerance) {
  auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto bar_beside = [&](double error) {
    prepared.reference_errors = [error] { return Quantities{{Quantity::stick_radius_shakedown, error}}; };
    return fake_study(prepared, {100, 0}).budget.at(Quantity::stick_radius_shakedown).total();
  };
  const double alone = bar_beside(0);
  EXPECT_LE(alone, 1e-3);
  const double error = 1.01e-3 - alone;  // a little more than is left over
  EXPECT_LE(bar_beside(error), std::max(1e-3 - error, 0.5e-3));
  EXPECT_LT(bar_beside(error), alone);
  EXPECT_LE(bar_beside(1), 0.5e-3);
}

TEST(Proof, RefinesOnlyWhatIsTooWide) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto& start = prepared.fem.resolution;
  const auto rings = fake_study(prepared, {100, 0});
  EXPECT_GT(rings.resolution.elements_per_radius, start.elements_per_radius);
  EXPECT_EQ(rings.resolution.steps_per_cycle, start.steps_per_cycle);
  EXPECT_LE(rings.budget.at(Quantity::stick_radius_shakedown).total(), 1e-3);
  const auto steps = fake_study(prepared, {0, 10});
  EXPECT_EQ(steps.resolution.elements_per_radius, start.elements_per_radius);
  EXPECT_GT(steps.resolution.steps_per_cycle, start.steps_per_cycle);
  EXPECT_LE(steps.budget.at(Quantity::stick_radius_shakedown).total(), 1e-3);
}

// Where rings make a bar too wide, only rings are computed there.
TEST(Proof, RefinesForTheRingsBeforeItLooksForOtherErrors) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto start = prepared.fem.resolution.elements_per_radius;
  std::vector<Resolution> asked;
  const FakeNumerics coarse{100, 0};
  const auto answer = prove(prepared, Proof::tolerance, {[&](const Resolution& r) {
                              asked.push_back(r);
                              return coarse(prepared.fem, r);
                            }},
                            1);
  EXPECT_GT(answer.resolution.elements_per_radius, start);
  const auto finer =
      std::find_if(asked.begin(), asked.end(), [=](const auto& r) { return r.elements_per_radius > start; });
  EXPECT_EQ(finer - asked.begin(), 4) << "itself, and with half the steps all, half and a quarter of its rings";
}

TEST(Proof, KeepsRingsAndStepsThatTheCaseFixes) {
  auto input = suite_case("parabola-solid-90", 1e-3);
  input.rings_per_radius = 20;
  input.steps_per_cycle = 30;
  const auto result = fake_study(prepare({input}).front(), {100, 10});
  EXPECT_EQ(result.resolution.elements_per_radius, 20U);
  EXPECT_EQ(result.resolution.steps_per_cycle, 30);
  EXPECT_GT(result.budget.at(Quantity::stick_radius_shakedown).total(), 1e-3);
}

// Two rings of the base stick at first; how well the edge is read is what the finer rings know.
TEST(Proof, TakesAFocusedRadiusWithTheUncertaintyOfItsReading) {
  const auto prepared = prepare({suite_case("parabola-elastic-90", 1e-3)}).front();
  const double length = prepared.fem.units.length;
  const FakeNumerics numerics{0, 0, 0.02, 0.5};
  const auto answer = prove(prepared, Proof::tolerance, {[&](const Resolution& r) {
                              auto one = numerics(prepared.fem, r);
                              one.first_slip_uncertainty = (r.focus ? 1e-6 : 1e-2) * length;
                              one.shakedown_uncertainty = 2e-6 * length;
                              return one;
                            }});
  ASSERT_EQ(answer.failure, "");
  ASSERT_EQ(answer.focus.count(Quantity::stick_radius_first_slip), 1U);
  EXPECT_NEAR(answer.fe.first_slip_uncertainty, 1e-6 * length, 1e-15);
  EXPECT_NEAR(answer.fe.shakedown_uncertainty, 2e-6 * length, 1e-15);
}

}  // namespace
}  // namespace fretval
