#include "comparison/accuracy/error_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace fretval {
namespace {

constexpr double safety = 1.5;  // for an observed order

/// Values with an error of exactly factor * h^order at h = 1, 2 and 4.
Refinements power(double order, double factor = 1e-3) {
  return {0.5 + factor, 0.5 + factor * std::exp2(order), 0.5 + factor * std::exp2(2 * order)};
}

Resolution some_resolution() {
  return resolution_for(1e-3);
}

TEST(Richardson, IsExactOnPowers) {
  for (const double order : {1.0, 2.0, 3.0}) {
    const auto share = richardson(ErrorSource::rings, power(order), {order});
    EXPECT_NEAR(share.estimate, safety * 1e-3, 1e-14);  // roundoff
    ASSERT_TRUE(share.order);
    EXPECT_NEAR(*share.order, order, 1e-10);
  }
}

TEST(Richardson, DoesNotTrustAnOrderAboveTheExpectedOne) {
  // Fourth order observed where third is expected: the error is taken for the larger one of third order.
  const auto share = richardson(ErrorSource::rings, power(4), {3});
  EXPECT_NEAR(share.estimate, safety * 1e-3 * (16 - 1) / (8 - 1), 1e-14);
}

TEST(Richardson, FallsBackWhenTheOrderIsNotCredible) {
  // An alternating sign, an order far too low, and one far too high: no observed order, and a larger safety factor.
  for (const auto& values : {Refinements{0.5, 0.501, 0.5005}, Refinements{0.5, 0.501, 0.5021}, power(7)}) {
    const auto share = richardson(ErrorSource::rings, values, {3});
    EXPECT_FALSE(share.order);
    EXPECT_GE(share.estimate, 3 * std::abs(values.fine - values.medium) / 7 * (1 - 1e-12));
    EXPECT_GE(share.estimate, 3 * std::abs(values.fine - *values.coarse) / 63 * (1 - 1e-12));
  }
}

// A coarse value says nothing by what its reading leaves open; a medium one may hide what its own does.
TEST(Richardson, TakesOfReadingsWhatTheyKnow) {
  const auto estimate = [](double medium_reading, double coarse_reading) {
    return richardson(ErrorSource::rings, {0.5, 0.501, 0.44, medium_reading, coarse_reading}, {3}).estimate;
  };
  EXPECT_NEAR(estimate(0, 0), 3 * 0.06 / 63, 1e-14);
  EXPECT_NEAR(estimate(0, 0.02), 3 * 0.04 / 63, 1e-14);
  EXPECT_NEAR(estimate(0, 0.1), 3 * 0.001 / 7, 1e-14);
  EXPECT_NEAR(estimate(0.004, 0.1), 3 * 0.005 / 7, 1e-14);
  EXPECT_NEAR(estimate(0.1, 0.1), 3 * 0.06 / 63, 1e-14) << "no more than the values themselves show";
}

TEST(Richardson, DoesWithoutTheCoarsestValue) {
  const auto share = richardson(ErrorSource::time_step, {0.5, 0.503, std::nullopt}, {2});
  EXPECT_NEAR(share.estimate, 3 * 0.003 / 3, 1e-14);
  EXPECT_FALSE(share.order);
}

TEST(ErrorBudget, SumsTheShares) {
  const ErrorBar bar{{{ErrorSource::rings, 1e-3, std::nullopt},
                      {ErrorSource::grading, 2e-3, std::nullopt},
                      {ErrorSource::edge, 4e-3, 3}}};
  EXPECT_DOUBLE_EQ(bar.total(), 7e-3);
  ASSERT_TRUE(bar.largest());
  EXPECT_EQ(bar.largest()->source, ErrorSource::edge);
  EXPECT_FALSE(ErrorBar{}.largest());
}

/// The quantities of a resolution and of all that its errors are measured by.
std::map<Resolution, Quantities> all_known(const Resolution& resolution, const CaseNeeds& needs,
                                           const std::function<double(const Resolution&)>& value) {
  std::map<Resolution, Quantities> known;
  const auto add = [&](const Resolution& r) { known[r] = {{Quantity::stick_radius_shakedown, value(r)}}; };
  add(resolution);
  for (const auto& variant : variants_of(resolution, needs)) {
    add(variant.resolution);
    add(variant.reference);
  }
  return known;
}

/// Of the rings, of a value whose error is 1e-3 at the resolution and of first order in them.
ErrorShare share_of_rings(const Resolution& resolution, const CaseNeeds& needs) {
  const auto first = [&](const Resolution& r) {
    return 0.5 + 1e-3 * resolution.elements_per_radius / r.elements_per_radius;
  };
  const auto budget = error_budget(resolution, all_known(resolution, needs, first), {}, needs);
  for (const auto& share : budget.begin()->second.shares)
    if (share.source == ErrorSource::rings) return share;
  return {};
}

// The shakedown radius, where rings touch in any order, and on rings and angles.
TEST(ErrorBudget, WhereZonesAreReadOffTheirRingsTheirFirstOrderIsBelieved) {
  for (const auto kind : {ContactKind::annuli, ContactKind::plane}) {
    CaseNeeds needs;
    needs.kind = kind;
    const auto share = share_of_rings(resolution_for(1e-3), needs);
    EXPECT_NEAR(share.order.value_or(0), 1, 1e-9);
    EXPECT_NEAR(share.estimate, safety * 1e-3, 1e-12);
  }
}

// Pressures uniform over rings leave the second order of what the base of a layer adds, also where it seems a third.
TEST(ErrorBudget, OverALayerRingsAreOfSecondOrder) {
  const auto resolution = resolution_for(1e-3);
  const auto third = [&](const Resolution& r) {
    return 0.5 + 1e-3 * std::pow(static_cast<double>(resolution.elements_per_radius) / r.elements_per_radius, 3);
  };
  const auto share_on = [&](bool ends) {
    CaseNeeds needs;
    needs.ends = ends;
    const auto budget = error_budget(resolution, all_known(resolution, needs, third), {}, needs);
    for (const auto& share : budget.begin()->second.shares)
      if (share.source == ErrorSource::rings) return share.estimate;
    return 0.0;
  };
  EXPECT_NEAR(share_on(false), safety * 1e-3, 1e-12);
  EXPECT_NEAR(share_on(true), 7.0 / 3 * safety * 1e-3, 1e-12);
}

// 16 rings have only 8 to be compared with, which show no order.
TEST(ErrorBudget, NextToTheSmallestContactAStickRadiusIsOfFirstOrder) {
  auto resolution = resolution_for(1e-3);
  resolution.elements_per_radius = 16;
  CaseNeeds needs;
  needs.shakedown_ends_with_contact = true;
  EXPECT_NEAR(share_of_rings(resolution, needs).estimate, 3 * 1e-3, 1e-12);
}

// Steps of 1, 2 and 4 of which the coarser ones cannot see a branch: the second order that they show is none.
TEST(ErrorBudget, BelievesNoOrderInTheStepWhereABranchRelaxesWithinIt) {
  const auto resolution = resolution_for(1e-3);
  const auto second = [&](const Resolution& r) {
    return 0.5 + 1e-3 * std::pow(static_cast<double>(resolution.steps_per_cycle) / r.steps_per_cycle, 2);
  };
  const auto step_share = [&](bool short_branch) {
    CaseNeeds needs;
    needs.has_short_branch = short_branch;
    const auto budget = error_budget(resolution, all_known(resolution, needs, second), {}, needs);
    for (const auto& share : budget.begin()->second.shares)
      if (share.source == ErrorSource::time_step) return share;
    return ErrorShare{};
  };
  EXPECT_NEAR(*step_share(false).order, 2, 1e-9);
  EXPECT_FALSE(step_share(true).order);
  EXPECT_NEAR(step_share(true).estimate, 2 * step_share(false).estimate, 1e-9);
}

TEST(ErrorBudget, HasAShareForEverySourceAndTheEdge) {
  CaseNeeds unlocked;
  unlocked.creep = true;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const auto resolution = resolution_for(tolerance);
    double value = 0.5;  // another one at each resolution
    const auto known = all_known(resolution, unlocked, [&](auto&&) { return value *= 1.001; });
    const auto budget = error_budget(resolution, known, {{Quantity::stick_radius_shakedown, 1e-5}}, unlocked);
    const auto& shares = budget.at(Quantity::stick_radius_shakedown).shares;
    // rings, element order, grading, far field, time step, start, creep, cycles, edge
    EXPECT_EQ(shares.size(), 9U);
    for (const auto& share : shares) EXPECT_GT(share.estimate, 0) << name_of(share.source);
  }
}

// The far field of a sheet falls with the second power of its distance, that of a half-space with the fourth.
TEST(ErrorBudget, BelievesLessOfTheFarFieldOfALayerThatSlides) {
  const auto resolution = resolution_for(1e-3);
  const auto second = [](const Resolution& r) { return 0.5 + 1e-3 * std::pow(r.far_radius, -2); };
  const auto far_share = [&](bool stretches) {
    CaseNeeds needs;
    needs.stretches = stretches;
    const auto budget = error_budget(resolution, all_known(resolution, needs, second), {}, needs);
    for (const auto& share : budget.begin()->second.shares)
      if (share.source == ErrorSource::far_field) return share.estimate;
    return 0.0;
  };
  const double error = 1e-3 * std::pow(resolution.far_radius, -2);
  EXPECT_NEAR(far_share(true), 3 * error, 1e-12);
  EXPECT_LT(far_share(false), error);
}

// Both ways of telling what the reading of an edge costs add up: what it says itself, and the same rings elsewhere.
TEST(ErrorBudget, MeasuresTheReadingOfEdgesElsewhereInTheirRings) {
  const auto resolution = resolution_for(1e-3);
  const auto known =
      all_known(resolution, CaseNeeds(), [](const Resolution& r) { return 0.5 + 1e-3 * r.edge_before_node; });
  const auto budget = error_budget(resolution, known, {{Quantity::stick_radius_shakedown, 1e-5}});
  EXPECT_NEAR(budget.at(Quantity::stick_radius_shakedown).total(), safety * 1e-3 + 1e-5, 1e-12);
}

// What happens within steps shows by steps that begin half a step later; nothing happens where the contact is largest.
TEST(ErrorBudget, MeasuresWhatHappensWithinStepsByOtherInstants) {
  const auto resolution = resolution_for(1e-3);
  CaseNeeds needs;
  needs.begins_anywhere = true;
  auto known = all_known(resolution, needs, [](const Resolution& r) { return 0.5 + 1e-3 * r.first_step; });
  for (auto& [r, quantities] : known)
    quantities[Quantity::contact_radius_max] = quantities.at(Quantity::stick_radius_shakedown);
  const auto budget = error_budget(resolution, known, {}, needs);
  EXPECT_NEAR(budget.at(Quantity::stick_radius_shakedown).total(), safety * 1e-3 / 2, 1e-12);
  EXPECT_EQ(budget.at(Quantity::stick_radius_shakedown).largest()->source, ErrorSource::instants);
  EXPECT_EQ(budget.at(Quantity::contact_radius_max).total(), 0);
}

TEST(ErrorBudget, KnowsWhatTheReadingOfAQuarterOfTheRingsLeavesOpen) {
  const auto resolution = resolution_for(1e-3);
  const auto variants = variants_of(resolution, CaseNeeds());
  const auto &half = variants[0].resolution, &quarter = variants[1].resolution;
  const auto known = all_known(resolution, CaseNeeds(), [&](const Resolution& r) {
    return r == quarter ? 0.44 : r == half ? 0.501 : 0.5;
  });
  const auto bar_with = [&](const Resolution& read, double uncertainty = 0.02) {
    const std::map<Resolution, Quantities> readings{{read, {{Quantity::stick_radius_shakedown, uncertainty}}}};
    return error_budget(resolution, known, {}, CaseNeeds(), readings).at(Quantity::stick_radius_shakedown).total();
  };
  EXPECT_NEAR(bar_with(half), 3 * 0.06 / 63, 1e-12);
  EXPECT_NEAR(bar_with(quarter), 3 * 0.04 / 63, 1e-12);
  constexpr double unknown = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(bar_with(quarter, unknown), 3 * 0.001 / 7, 1e-12) << "the one difference that is left";
  EXPECT_EQ(bar_with(half, unknown), unknown);
}

TEST(ErrorBudget, OfTheCyclesToShakedownTakesTheStartAsItIs) {
  const auto resolution = resolution_for(1e-3);
  auto known = all_known(resolution, CaseNeeds(), [](const Resolution& r) { return 0.1 * r.n_ramp_cycles; });
  for (auto& [r, quantities] : known)
    quantities[Quantity::cycles_to_shakedown] = quantities.at(Quantity::stick_radius_shakedown);
  const auto budget = error_budget(resolution, known, {});
  EXPECT_GT(budget.at(Quantity::stick_radius_shakedown).total(), 0);
  EXPECT_EQ(budget.at(Quantity::cycles_to_shakedown).total(), 0);
}

TEST(ErrorBudget, MeasuresWhatIsThere) {
  // Errors of third order in the rings and of second in the steps, seen through coarser rings where those are many.
  const auto resolution = resolution_for(1e-4);
  const auto known = all_known(resolution, CaseNeeds(), [](const Resolution& r) {
    return 0.5 + std::pow(r.elements_per_radius, -3) + 0.1 * std::pow(r.steps_per_cycle, -2);
  });
  const auto budget = error_budget(resolution, known, {});
  for (const auto& share : budget.at(Quantity::stick_radius_shakedown).shares) {
    if (share.source == ErrorSource::rings)
      EXPECT_NEAR(share.estimate, safety * std::pow(48, -3), 1e-12);
    else if (share.source == ErrorSource::time_step)
      EXPECT_NEAR(share.estimate, safety * 0.1 * std::pow(72, -2), 1e-12);
    else
      EXPECT_EQ(share.estimate, 0) << name_of(share.source);
  }
}

// Steps that scatter tell no order. With rings that are held from the start of their step they are of first order.
TEST(ErrorBudget, TakesFrictionForFirstOrderInTimeWhereRingsAreHeld) {
  const auto resolution = resolution_for(1e-3);
  const auto steps = [&](double share) { return static_cast<int>(share * resolution.steps_per_cycle); };
  const auto estimate = [&](bool held, Quantity quantity) {
    CaseNeeds needs;
    needs.held_from_start = held;
    auto known = all_known(resolution, needs, [&](const Resolution& r) {
      return r.steps_per_cycle == steps(0.5) ? 0.501 : r.steps_per_cycle == steps(0.25) ? 0.5005 : 0.5;
    });
    for (auto& [r, quantities] : known) quantities[quantity] = quantities.at(Quantity::stick_radius_shakedown);
    const auto budget = error_budget(resolution, known, {}, needs);
    for (const auto& share : budget.at(quantity).shares)
      if (share.source == ErrorSource::time_step) return share.estimate;
    return 0.0;
  };
  for (const auto quantity : {Quantity::stick_radius_shakedown, Quantity::worn_volume}) {
    EXPECT_NEAR(estimate(true, quantity), 3 * 0.001, 1e-12);
    EXPECT_NEAR(estimate(false, quantity), 3 * 0.001 / 3, 1e-12);
  }
}

// One order less changes the value by d. Errors go with h to the order: that of degree p is d^(p/(p-1)), three times
// for safety; quadratic elements are compared with cubic ones instead, and have the error d itself.
TEST(ErrorBudget, KnowsTheElementOrderFromTheOneBelow) {
  constexpr double d = 1e-4;
  const std::map<unsigned, double> shares{{2, 1.25e-4}, {3, 3e-6}, {4, 3 * std::cbrt(1e-16)}};
  for (const auto& [degree, wanted] : shares) {
    auto resolution = some_resolution();
    resolution.degree = degree;
    const auto known =
        all_known(resolution, CaseNeeds(), [p = degree](const Resolution& r) { return r.degree == p ? 0.5 : 0.5 + d; });
    const auto budget = error_budget(resolution, known, {});
    for (const auto& share : budget.at(Quantity::stick_radius_shakedown).shares) {
      const bool order = share.source == ErrorSource::element_order;
      EXPECT_NEAR(share.estimate, order ? wanted : 0, 1e-12) << degree << name_of(share.source);
    }
  }
}

// Errors 1e-3 h + 2e-3 h³ look like third order at h = 1, 2, 4, in which the term of first order is lost.
TEST(ErrorBudget, SeesFirstOrderInStickRadiiNextToTheSmallestContact) {
  const auto resolution = some_resolution();
  const auto known = all_known(resolution, CaseNeeds(), [&](const Resolution& r) {
    const double h = static_cast<double>(resolution.elements_per_radius) / r.elements_per_radius;
    return 0.5 + 1e-3 * h + 2e-3 * h * h * h;
  });
  const auto bar = [&](const CaseNeeds& needs) {
    return error_budget(resolution, known, {}, needs).at(Quantity::stick_radius_shakedown).total();
  };
  CaseNeeds needs;
  EXPECT_LT(bar(needs), safety * 2.8e-3);
  needs.first_slip_ends_with_contact = true;
  EXPECT_LT(bar(needs), safety * 2.8e-3);
  needs.shakedown_ends_with_contact = true;
  EXPECT_NEAR(bar(needs), safety * 3e-3, 1e-12);
}

TEST(ErrorBudget, TakesGradedRingsForSecondOrder) {
  // First-slip radius of a worn power law in a viscoelastic body at 32, 16 and 8 rings (random case 1048): order 4.4
  // from one to the next, but 2 from there on (2.0e-4, 4.3e-5, 9.9e-6 at 32, 64, 128 rings).
  const auto resolution = some_resolution();
  const auto value = [&](const Resolution& r) {
    const double coarseness = static_cast<double>(resolution.elements_per_radius) / r.elements_per_radius;
    return coarseness > 3 ? -5.02e-3 : coarseness > 1.5 ? -4.12e-4 : -2.01e-4;
  };
  const auto bar = [&](bool worn) {
    CaseNeeds needs;
    needs.kind = worn ? ContactKind::worn : ContactKind::discs;
    return error_budget(resolution, all_known(resolution, needs, value), {}, needs)
        .at(Quantity::stick_radius_shakedown)
        .total();
  };
  EXPECT_GT(bar(true), 2.01e-4);
  EXPECT_LT(bar(true), 20 * 2.01e-4);
  EXPECT_LT(bar(false), bar(true));
}

/// Resolutions that are the coarser one of two of their source.
std::set<Resolution> coarsest_ones(const Resolution& resolution) {
  std::set<Resolution> coarsest;
  const auto variants = variants_of(resolution, CaseNeeds());
  for (std::size_t i = 1; i < variants.size(); ++i)
    if (variants[i].source == variants[i - 1].source) coarsest.insert(variants[i].resolution);
  return coarsest;
}

// What could not be computed leaves everything open, unless a finer one tells the error as well.
TEST(ErrorBudget, IsInfiniteWhereAComputationFailedButForTheCoarsest) {
  const auto resolution = some_resolution();
  const auto coarsest = coarsest_ones(resolution);
  const auto complete = all_known(resolution, CaseNeeds(), [](auto&&) { return 0.5; });
  ASSERT_GE(coarsest.size(), 2U);
  EXPECT_EQ(error_budget(resolution, complete, {}).at(Quantity::stick_radius_shakedown).total(), 0);
  for (const auto& [missing, quantities] : complete) {
    if (missing == resolution) continue;
    auto known = complete;
    known[missing] = {};  // its numerics failed
    EXPECT_EQ(error_budget(resolution, known, {}).at(Quantity::stick_radius_shakedown).total(),
              coarsest.count(missing) > 0 ? 0 : std::numeric_limits<double>::infinity());
  }
}

// A quantity that the coarsest computation has no value of, where it has others, may be off by anything.
TEST(ErrorBudget, IsInfiniteWhereTheCoarsestHasNoValue) {
  const auto resolution = some_resolution();
  auto known = all_known(resolution, CaseNeeds(), [](auto&&) { return 0.5; });
  known[*coarsest_ones(resolution).begin()] = {{Quantity::normal_force_max, 1}};
  EXPECT_EQ(error_budget(resolution, known, {}).at(Quantity::stick_radius_shakedown).total(),
            std::numeric_limits<double>::infinity());
}

// Errors fall at least with the first power of the cells: of h and h/2 the difference is half of the error.
TEST(ErrorBudget, OfAGivenMeshIsTwiceTheDifferenceFromItsCellsSplit) {
  auto given = resolution_for(1e-3);
  given.mesh_refinements = 0;
  auto finer = given;
  finer.mesh_refinements = 1;
  const auto change = [](const Resolution&, const Resolution&) { return -1e-3; };
  EXPECT_NEAR(
      error_bar(Quantity::normal_force_max, {{ErrorSource::grading, finer, given}}, change, CaseNeeds()).total(), 2e-3,
      1e-15);
}

// The edge of the contact is read between two steps, that of a stick zone between two rings.
TEST(ErrorBudget, CountsTheReadingOfTheContactRadiusToTheSteps) {
  const auto resolution = resolution_for(1e-3);
  const Quantities values{{Quantity::contact_radius_max, 1}, {Quantity::stick_radius_shakedown, 0.5}},
      readings{{Quantity::contact_radius_max, 1e-3}, {Quantity::stick_radius_shakedown, 1e-3}};
  const auto budget = error_budget(resolution, std::vector<Variant>{}, {{resolution, values}}, readings, CaseNeeds());
  EXPECT_EQ(budget.at(Quantity::contact_radius_max).largest()->source, ErrorSource::time_step);
  EXPECT_EQ(budget.at(Quantity::stick_radius_shakedown).largest()->source, ErrorSource::edge);
}

}  // namespace
}  // namespace fretval
