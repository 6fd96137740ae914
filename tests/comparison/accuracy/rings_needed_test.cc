#include "comparison/accuracy/rings_needed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "comparison/simulation/compute_case.h"
#include "tests/comparison/given_mesh.h"

namespace fretval {
namespace {

/// The case of a tolerance whose answer has a bar for the stick radius.
std::optional<GivenRings> rings_with(
    const ErrorBar& bar, bool given = true, const std::function<void(ProvedAnswer&)>& change = [](ProvedAnswer&) {}) {
  ScratchFolder folder;
  auto input = case_with_mesh(folder, pad_mesh(24));
  if (!given) input.body = {};
  ProvedAnswer answer{};
  answer.fe.rings.contact = 20;
  answer.budget[Quantity::stick_radius_shakedown] = bar;
  change(answer);
  return given_rings_of(prepare({input}).front(), answer);
}

TEST(RingsNeeded, AreThoseOfTheMeshWhereBarsMeetTheirTolerance) {
  const auto rings = rings_with({{{ErrorSource::rings, 5e-3, 3.0}}}).value();
  EXPECT_EQ(rings.in_contact, 20U);
  EXPECT_FALSE(rings.needed);
  EXPECT_FALSE(rings_with({{{ErrorSource::rings, 5e-3, 3.0}}}, false));
}

// Of the tolerance of 0.01: eight times too wide, of third order; four times, of second.
TEST(RingsNeeded, FollowFromTheOrder) {
  EXPECT_NEAR(rings_with({{{ErrorSource::rings, 8e-2, 3.0}}})->needed.value(), 40, 2);
  EXPECT_NEAR(rings_with({{{ErrorSource::edge, 4e-2, {}}}})->needed.value(), 40, 2);
  EXPECT_NEAR(rings_with({{{ErrorSource::grading, 2e-2, {}}}})->needed.value(), 40, 2);
  // Where something else leaves nothing, half of the tolerance is what the mesh may take.
  EXPECT_NEAR(rings_with({{{ErrorSource::rings, 2e-2, {}}, {ErrorSource::time_step, 0.1, {}}}})->needed.value(), 40, 2);
}

TEST(RingsNeeded, AreTwiceAsManyWhereABarIsUnknown) {
  EXPECT_EQ(rings_with({{{ErrorSource::rings, std::numeric_limits<double>::infinity(), {}}}})->needed, 40U);
}

// Rings and the edge that is read from them are eight times too wide together, of second order.
TEST(RingsNeeded, FollowFromAllThatTheMeshLeavesOpen) {
  const ErrorBar both{{{ErrorSource::rings, 6e-2, {}}, {ErrorSource::edge, 2e-2, {}}}};
  EXPECT_NEAR(rings_with(both)->needed.value(), 20 * std::sqrt(8), 3);
}

TEST(RingsNeeded, AreThoseOfTheWidestBar) {
  const ErrorBar wide{{{ErrorSource::rings, 0.16, {}}}}, narrow{{{ErrorSource::rings, 2e-2, {}}}};
  const auto needed = [](const ErrorBar& of_slip, const ErrorBar& of_shakedown) {
    const auto rings = rings_with(
        of_shakedown, true, [&](ProvedAnswer& answer) { answer.budget[Quantity::stick_radius_first_slip] = of_slip; });
    return rings->needed.value();
  };
  EXPECT_NEAR(needed(wide, narrow), 80, 4);
  EXPECT_EQ(needed(narrow, wide), needed(wide, narrow));
}

TEST(RingsNeeded, AreNotSaidWhereAllOfTheContactSlides) {
  EXPECT_FALSE(rings_with({}, true, [](ProvedAnswer& answer) { answer.fe.of_kind = GrossSlipStart{}; }));
}

// On the same rings a layer that is given as a mesh is the layer: its contact and its force, each to its bar.
TEST(RingsNeeded, OfALayerOfOursAreProvedToBeTheLayer) {
  ScratchFolder folder;
  auto layer = read_case_file(folder.write("layer.prm", valid_case + "subsection Body\n  set Shape = cylinder\n"
                                                                     "  set Thickness = 3 mm\n  set Radius = 6 mm\n"
                                                                     "  set Base = bonded\nend\n"))
                   .front();
  BodyStore bodies;
  const auto own = prepare({case_with_mesh(folder, pad_mesh(36))}).front(), ours = prepare({layer}).front();
  const auto by_mesh = prove(own, Proof::bars, bodies), generated = prove(ours, Proof::bars, bodies);
  ASSERT_EQ(by_mesh.failure, "");
  const auto within_bars = [&](Quantity quantity, double a, double b, double scale) {
    const double bars = by_mesh.budget.at(quantity).total() + generated.budget.at(quantity).total();
    EXPECT_LT(std::abs(a - b) / scale, bars) << traits_of(quantity).title;
    EXPECT_LT(bars, 0.05) << traits_of(quantity).title;
  };
  const auto &a = by_mesh.fe, &b = generated.fe;
  within_bars(Quantity::contact_radius_max, *a.contact_radius_max, *b.contact_radius_max, *b.contact_radius_max);
  within_bars(Quantity::normal_force_max, a.normal_force_max, b.normal_force_max, b.normal_force_max);
  within_bars(Quantity::stick_radius_shakedown, *a.stick_radius_shakedown, *b.stick_radius_shakedown,
              *b.contact_radius_max);
}

}  // namespace
}  // namespace fretval
