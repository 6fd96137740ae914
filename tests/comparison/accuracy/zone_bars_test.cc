#include "comparison/accuracy/zone_bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "comparison/accuracy/proof.h"
#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/damaged_case.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/suite_case.h"

namespace fretval::zone_bars_test {
namespace {

ProvedAnswer with_bars(const PreparedCase& prepared) {
  return prove(prepared, Proof::bars, shared_bodies());
}

/// Zones that are a hundredth too large at the coarsest rings, of third order; lengths in units of the case.
ZoneBudget budget_of_known_zones(double pressure) {
  auto prepared = prepare({suite_case("parabola-elastic-90", 1e-2)}).front();
  prepared.fem.kind = ContactKind::annuli;
  const auto& fem = prepared.fem;
  const double length = fem.units.length;
  const auto answer_at = [&](const Resolution& r) {
    const double larger = 1 + 0.01 * std::pow(24.0 / r.elements_per_radius, 3);
    BodySummary body{};
    body.radii = {0, 0.25, 0.5, 0.75, 1};
    FeAnswer fe;
    fe.body = std::make_shared<const BodySummary>(body);
    fe.normal_force_max = fem.units.force();
    fe.of_kind = ZoneAnswer{{{0, larger * length}},
                            {{0, 0.2 * larger * length}, {0.3 * larger * length, 0.4 * larger * length}},
                            {{0, 0.6 * larger * length}},
                            0.02 * length,
                            pressure * larger};
    return fe;
  };
  const auto needs = needs_of(fem);
  Computations computed(fem.units, answer_at, 1);
  std::vector<Resolution> all{fem.resolution};
  for (const auto& variant : variants_of(fem.resolution, needs)) {
    all.push_back(variant.reference);
    all.push_back(variant.resolution);
  }
  computed.compute(all);
  return zone_budget(fem.resolution, computed, needs);
}

double edge_share(const std::optional<ErrorBar>& bar) {
  for (const auto& share : bar.value().shares)
    if (share.source == ErrorSource::edge) return share.estimate;
  return 0;
}

// Of the contact what it is uncertain by, of zones that stick half of a ring: four rings to 1 contact radius.
TEST(ZoneBars, HaveTheRingsAndTheReadingOfTheirEndsOverTheContactRadius) {
  const auto bars = budget_of_known_zones(1);
  ASSERT_EQ(bars.contact.size(), 1U);
  ASSERT_EQ(bars.first_slip.size(), 2U);
  ASSERT_EQ(bars.shakedown.size(), 1U);
  EXPECT_NEAR(edge_share(bars.contact[0].outer), 0.02, 1e-12);
  EXPECT_NEAR(edge_share(bars.first_slip[1].inner), 0.125, 1e-12);
  EXPECT_NEAR(edge_share(bars.shakedown[0].outer), 0.125, 1e-12);
  EXPECT_GT(bars.contact[0].outer->total(), 0.021);
}

// The bar of the pressure is relative.
TEST(ZoneBars, OfThePressureDoNotKnowItsUnit) {
  const double bar = budget_of_known_zones(1).pressure_max.total();
  EXPECT_GT(bar, 1e-3);
  EXPECT_NEAR(budget_of_known_zones(1e6).pressure_max.total(), bar, 1e-9);
}

// A whole indenter, read as if its rings touched in any order: MDR is exact, and within the bars.
TEST(ZoneBars, CoverTheExactAnswerOfAWholeIndenter) {
  for (const char* name : {"parabola-elastic-90", "cone-elastic-0"}) {
    auto prepared = prepare({suite_case(name, 1e-2)}).front();
    const auto& mdr = prepared.mdr;
    const auto exact = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
    prepared.fem.kind = ContactKind::annuli;
    const auto answer = with_bars(prepared);
    ASSERT_EQ(answer.failure, "");
    const auto& fe = answer.fe;
    const auto bar = [&](Quantity quantity) { return answer.budget.at(quantity).total(); };
    const double force = std::abs(std::log(fe.normal_force_max / exact.normal_force_max.value())),
                 radius = std::abs(std::log(fe.contact_radius_max.value() / exact.contact_radius_max.value())),
                 tangential = std::abs(std::log(fe.cycle->value(Quantity::tangential_force_max) /
                                                exact.cycle->value(Quantity::tangential_force_max))),
                 work =
                     std::abs(fe.cycle->value(Quantity::friction_work) - exact.cycle->value(Quantity::friction_work)) /
                     fe.cycle->sliding_work;
    EXPECT_LE(force, bar(Quantity::normal_force_max)) << name;
    EXPECT_LE(radius, bar(Quantity::contact_radius_max)) << name;
    EXPECT_LE(tangential, bar(Quantity::tangential_force_max)) << name;
    // The springs have an error of their own, and nothing slips under the cone.
    EXPECT_LE(work,
              bar(Quantity::friction_work) + exact.cycle->uncertainty(Quantity::friction_work) / fe.cycle->sliding_work)
        << name;
    EXPECT_LT(bar(Quantity::normal_force_max), 0.05) << name << ": a bar that says something";
    const auto& zones = answer.zone_bars.value();
    ASSERT_EQ(zones.shakedown.size(), 1U);
    EXPECT_FALSE(zones.shakedown[0].inner);
    const double length = prepared.fem.units.length;
    EXPECT_LE(std::abs(fe.as<ZoneAnswer>()->shakedown[0].outer - exact.stick_radius_shakedown.value()),
              zones.shakedown[0].outer.value().total() * length)
        << name;
    EXPECT_LE(std::abs(fe.as<ZoneAnswer>()->contact[0].outer - exact.contact_radius_max.value()),
              zones.contact[0].outer.value().total() * length)
        << name;
    EXPECT_EQ(answer.budget.count(Quantity::stick_radius_shakedown), 0U) << "ends of zones stand for it";
  }
}

// The same on half the rings: twice the bar or more, and both answers within both bars.
TEST(ZoneBars, OfAGrooveShrinkWithTheRings) {
  auto prepared = prepared_damaged(groove(0.5, 0.7, 0.04));
  const auto fine = with_bars(prepared);
  prepared.fem.resolution = with_rings(prepared.fem.resolution, 0.5);
  prepared.fem = at_resolution(prepared.fem, prepared.fem.resolution);
  const auto coarse = with_bars(prepared);
  const double length = prepared.fem.units.length;
  ASSERT_EQ(coarse.fe.as<ZoneAnswer>()->contact.size(), 2U);
  ASSERT_EQ(fine.fe.as<ZoneAnswer>()->contact.size(), 2U);
  for (const std::size_t k : {0U, 1U}) {
    const double difference =
        std::abs(coarse.fe.as<ZoneAnswer>()->contact[k].outer - fine.fe.as<ZoneAnswer>()->contact[k].outer) / length;
    const double wide = coarse.zone_bars->contact[k].outer.value().total(),
                 narrow = fine.zone_bars->contact[k].outer.value().total();
    EXPECT_LE(difference, wide + narrow);
    EXPECT_LT(narrow, wide);
  }
  const double difference = std::abs(std::log(coarse.fe.normal_force_max / fine.fe.normal_force_max));
  EXPECT_LE(difference, coarse.budget.at(Quantity::normal_force_max).total());
  EXPECT_GT(coarse.zone_bars->pressure_max.total(), 0);
}

}  // namespace
}  // namespace fretval::zone_bars_test
