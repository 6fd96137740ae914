#include "comparison/accuracy/case_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "comparison/accuracy/study_driver.h"
#include "comparison/case/case_file.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/results/batch.h"
#include "mdr/stick/stick_radius.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

struct Studied {
  PreparedCase prepared;
  StudyResult result;
  double exact;  ///< shakedown radius over the unworn contact radius

  [[nodiscard]] double shakedown() const {
    return result.answer.fe.stick_radius_shakedown.value() / prepared.fem.units.length;
  }
};

Studied study(const Case& scene) {
  Studied studied{prepare({scene}).front(), {}, 0};
  std::vector<CaseStudy> studies{CaseStudy(studied.prepared, StudyDepth::proof)};
  run_studies(studies, [](const BodySpecification& s) { return make_body(s); });
  studied.result = studies.front().result();
  const auto& mdr = studied.prepared.mdr;
  const auto radii = mdr::stick_radii(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.motion);
  studied.exact = radii.shakedown.value() / studied.prepared.fem.units.length;
  return studied;
}

TEST(CaseStudySlow, FocusesOnASmallStickZone) {
  const auto studied = study(suite_case("small-stick-parabola", 1e-3));
  ASSERT_EQ(studied.result.answer.failure, "");
  EXPECT_NEAR(studied.exact, 0.02, 1e-9);
  EXPECT_EQ(studied.result.focus.count("stick_radius_shakedown"), 1U);
  EXPECT_NEAR(studied.shakedown(), studied.exact, 0.05 * studied.exact);
}

TEST(CaseStudySlow, FocusesOnANarrowSlipAnnulus) {
  const auto studied = study(suite_case("narrow-slip-parabola", 1e-3));
  ASSERT_EQ(studied.result.answer.failure, "");
  EXPECT_NEAR(studied.exact, 0.999, 1e-9);
  EXPECT_EQ(studied.result.focus.count("stick_radius_shakedown"), 1U);
  EXPECT_NEAR(studied.shakedown(), studied.exact, 0.05 * (1 - studied.exact));
}

TEST(CaseStudySlow, DoesNotFocusWhereRingsResolveTheZones) {
  const auto studied = study(suite_case("parabola-elastic-90", 1e-3));
  EXPECT_TRUE(studied.result.focus.empty());
  EXPECT_NEAR(studied.shakedown(), studied.exact, 1e-3);
}

// At 24 rings the force was 5.6e-5 off under a bar of 2.5e-5: a worn profile on 6 rings tells nothing of finer ones.
TEST(CaseStudySlow, ForceOfAWornProfileIsWithinItsBar) {
  const auto cases = read_case_file(std::filesystem::path(FRETVAL_SOURCE_DIR) / "cases/figure4/figure4-parabola.prm");
  const auto& scene = cases.at(3);
  EXPECT_EQ(scene.worn_stick_ratio, 0.4);
  const auto studied = study(scene);
  const auto& mdr = studied.prepared.mdr;
  const double exact = mdr_answer(mdr, mdr_normal_response(mdr)).normal_force_max.value();
  EXPECT_NEAR(studied.result.answer.fe.normal_force_max / exact, 1,
              studied.result.budget.at("normal_force_max").total());
}

/// Lets a study believe that it computed what it asked for: every answer is the exact one but for an error that the
/// rings and the steps make.
struct FakeNumerics {
  double ring_error, step_error;  ///< at 1 ring per radius and 1 step a cycle, of third and second order

  ProbeAnswer operator()(const PreparedCase& prepared, const Resolution& r) const {
    const double rings = r.elements_per_radius, steps = r.steps_per_cycle;
    const double error = ring_error / (rings * rings * rings) + step_error / (steps * steps);
    const double length = prepared.fem.units.length;
    ProbeAnswer answer;
    answer.fe.contact_radius_max = length;
    answer.fe.stick_radius_first_slip = answer.fe.stick_radius_shakedown = (0.5 + error) * length;
    answer.fe.normal_force_max = prepared.fem.units.force();
    answer.fe.rings.contact = static_cast<Eigen::Index>(rings);
    answer.fe.n_steps = 10L * r.steps_per_cycle;
    BodySummary body{};
    body.n_dofs = 500 * r.elements_per_radius;
    body.radii = at_resolution(prepared.fem, r).body.contact_nodes;
    answer.body = std::make_shared<const BodySummary>(body);
    return answer;
  }
};

StudyResult fake_study(const PreparedCase& prepared, const FakeNumerics& numerics,
                       StudyDepth depth = StudyDepth::proof) {
  CaseStudy study(prepared, depth);
  while (!study.wanted().empty()) {
    const auto wanted = study.wanted();
    for (const auto& resolution : wanted) study.take(resolution, numerics(prepared, resolution));
    study.advance();
  }
  return study.result();
}

TEST(CaseStudy, KeepsWhatIsFineEnough) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto result = fake_study(prepared, {0.1, 0.01});
  EXPECT_EQ(result.n_refinements, 0);
  EXPECT_EQ(result.resolution.elements_per_radius, prepared.fem.resolution.elements_per_radius);
  EXPECT_LE(result.budget.at("stick_radius_shakedown").total(), 1e-3);
}

TEST(CaseStudy, RefinesOnlyWhatIsTooWide) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const auto& start = prepared.fem.resolution;
  const auto rings = fake_study(prepared, {100, 0});
  EXPECT_GT(rings.resolution.elements_per_radius, start.elements_per_radius);
  EXPECT_EQ(rings.resolution.steps_per_cycle, start.steps_per_cycle);
  EXPECT_LE(rings.budget.at("stick_radius_shakedown").total(), 1e-3);
  const auto steps = fake_study(prepared, {0, 10});
  EXPECT_EQ(steps.resolution.elements_per_radius, start.elements_per_radius);
  EXPECT_GT(steps.resolution.steps_per_cycle, start.steps_per_cycle);
  EXPECT_LE(steps.budget.at("stick_radius_shakedown").total(), 1e-3);
}

TEST(CaseStudy, KeepsRingsAndStepsThatTheCaseFixes) {
  auto scene = suite_case("parabola-solid-90", 1e-3);
  scene.rings_per_radius = 20;
  scene.steps_per_cycle = 30;
  const auto result = fake_study(prepare({scene}).front(), {100, 10});
  EXPECT_EQ(result.resolution.elements_per_radius, 20U);
  EXPECT_EQ(result.resolution.steps_per_cycle, 30);
  EXPECT_GT(result.budget.at("stick_radius_shakedown").total(), 1e-3);
}

TEST(CaseStudy, EconomisesWithinTheTolerance) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const FakeNumerics numerics{1, 0.5};
  const auto result = fake_study(prepared, numerics, StudyDepth::economy);
  ASSERT_TRUE(result.cheapest);
  ASSERT_EQ(result.cheapest->resolutions.size(), 1U);
  const auto& cheap = result.cheapest->resolutions.front();
  EXPECT_LT(cheap.elements_per_radius * static_cast<unsigned>(cheap.steps_per_cycle),
            result.resolution.elements_per_radius * static_cast<unsigned>(result.resolution.steps_per_cycle));
  const double error = std::abs(result.cheapest->measures.at("stick_radius_shakedown") - 0.5);
  const double bar = result.cheapest->bars.at("stick_radius_shakedown");
  EXPECT_GT(error, 0);
  EXPECT_LE(error, bar);
  EXPECT_LE(bar, 1e-3);
  EXPECT_FALSE(fake_study(prepared, numerics).cheapest);
}

TEST(CaseStudy, RefinesOnceMoreWhereABarLeavesLittleToTheEconomy) {
  const auto prepared = prepare({suite_case("parabola-solid-90", 1e-3)}).front();
  const FakeNumerics numerics{9, 0};  // the bar is 0.8 of the tolerance
  EXPECT_EQ(fake_study(prepared, numerics).n_refinements, 0);
  const auto economised = fake_study(prepared, numerics, StudyDepth::economy);
  EXPECT_EQ(economised.n_refinements, 1);
  EXPECT_LT(economised.budget.at("stick_radius_shakedown").total(), 0.5e-3);
}

}  // namespace
}  // namespace fretval
