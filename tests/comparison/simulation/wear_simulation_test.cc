#include "comparison/simulation/wear_simulation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "comparison/simulation/compute_case.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/wearing_case.h"

namespace fretval {
namespace {

const std::string archard = "  set Coefficient = 1e-12\n";

Resolution coarse() {
  Resolution r = resolution_for_wear(resolution_for(1e-3));
  r.elements_per_radius = 24;
  r.degree = 3;
  r.steps_per_cycle = 48;
  r.worn_edge_ring = 1e-2;
  return r;
}

WearSimulation worn_by(const std::string& wear, double stick_radius = 0.594, const std::string& motion = "") {
  const auto prepared = wearing_case(wear, motion);
  return simulate_wear(prepared.fem, *prepared.input.wear_kinetics, {stick_radius, 1.5}, coarse(), shared_bodies());
}

// The limiting profile of the parabola (docs/theory.md): f_inf = f0 at a_inf/a0 = 1.2298 for c = 0.5 a0, 1.1429 for
// 0.7; by interpolation in c^2 1.1898. Read to third order in the rings of 1/24.
TEST(WearSimulation, EndsWithItsWearAtTheOuterRadius) {
  const auto wear = worn_by(archard);
  EXPECT_EQ(wear.course.end, fem::WearEnd::nothing_left);
  EXPECT_NEAR(wear.worn_radius, 1.1898, 2e-4);
  EXPECT_LT(wear.worn_radius_uncertainty, 1e-3);
  EXPECT_NEAR(wear.unworn[20], std::pow(wear.centre[20], 2) / 2, 1e-12);
  EXPECT_NEAR(wear.centre[0], wear.radii[1] / std::sqrt(2), 1e-12);
}

// A cycle takes 1e-9 of what there is to wear, out to the edge of the contact all the same.
TEST(WearSimulation, KnowsHowFarOutALittleWearGoes) {
  const auto wear = worn_by("  set Coefficient = 1e-16\n  set Cycles = 1\n");
  EXPECT_LT(wear.end.worn.maxCoeff(), 1e-7);
  EXPECT_NEAR(wear.worn_radius, 1, 1.0 / 24);
  EXPECT_EQ(worn_by("  set Coefficient = 1e-12\n  set Cycles = 0\n").worn_radius, 0);
}

// As worn_profile.csv has them.
std::string rows_of(const WearSimulation& wear) {
  std::string rows = "r [m],f [m]\n0,0\n";
  for (Eigen::Index i = 0; i < wear.centre.size(); ++i)
    rows +=
        fmt::format("{:.10g},{:.10g}\n", 1e-3 * wear.centre[i], 1e-4 * (wear.unworn[i] + wear.course.worn.back()[i]));
  return rows;
}

// Half of the way, written as a table, and the rest from there: the volumes of half as many cycles twice and of all at
// once. Friction begins anew, without traction; by the second half it has settled.
TEST(WearSimulation, GoesOnFromATableOfTheWornProfile) {
  const auto whole = worn_by(archard + "  set Cycles = 2e7\n"), half = worn_by(archard + "  set Cycles = 1e7\n");
  const double half_volume = half.course.curve.back().volume, volume = whole.course.curve.back().volume;
  ASSERT_GT(volume, 1.3 * half_volume);
  const ScratchFolder folder;
  const auto table = folder.write("worn.csv", rows_of(half));
  const auto rest = worn_by(archard + "  set Cycles = 1e7\n  set Profile = " + table.string() + "\n");
  EXPECT_NEAR(rest.course.curve.front().volume, half_volume, 1e-3 * half_volume);  // linear between rings of 1/24
  EXPECT_NEAR(rest.course.curve.back().volume, volume, 2e-3 * volume);
  EXPECT_LT((rest.course.worn.back() - whole.course.worn.back()).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_EQ(rest.course.curve.back().stick_radius, whole.course.curve.back().stick_radius);
}

// Whichever ring the edge lies in: the closed form of the limit, to second order in rings of 1/24.
TEST(WearSimulation, EndsWithTheVolumeOfTheLimitWhereverTheEdgeLiesInItsRing) {
  const double c = 1e-3 * std::sqrt(0.8 - std::hypot(0.4, 0.2));
  const double limit = mdr::worn_volume(mdr::limiting_profile(mdr::parabola(1e-2), c, 1e-4)) / (1e-4 * 1e-6);
  for (const double node : {0.58, 0.594, 0.605}) {
    const auto wear = worn_by(archard, node);
    EXPECT_TRUE(wear.end.is_shared);
    EXPECT_NEAR(wear.end.stick.radius, 1e3 * c, 2e-4) << node;
    EXPECT_NEAR(wear.end_volume / limit, 1, 1e-3) << node;
  }
}

// By its rings, to roundoff, onto the same rings and onto others.
TEST(WearSimulation, GoesOnFromItsRingsWithTheSameVolume) {
  const auto half = worn_by(archard + "  set Cycles = 1e7\n");
  std::string rows = "r outer [m],worn depth [m]\n";
  for (Eigen::Index i = 0; i < half.centre.size(); ++i)
    rows += fmt::format("{:.17g},{:.17g}\n", 1e-3 * half.radii[static_cast<std::size_t>(i) + 1],
                        1e-4 * half.course.worn.back()[i]);
  const ScratchFolder folder;
  const auto table = folder.write("rings.csv", rows);
  const auto from_them = archard + "  set Cycles = 1\n  set Worn rings = " + table.string() + "\n";
  const double volume = half.course.curve.back().volume;
  for (const double stick_radius : {0.594, 0.55}) {
    const auto rest = worn_by(from_them, stick_radius);
    EXPECT_NEAR(rest.course.curve.front().volume / volume, 1, 1e-12) << stick_radius;
  }
}

// The same table as an indenter of its own, which does not wear and of which MDR does not hold: it bears what it
// bears in the first cycle of wear on it. Sums over rings of 1/24 a, and profiles linear between them.
TEST(WearSimulation, TheWornProfileIsAnIndenterOfItsOwn) {
  const ScratchFolder folder;
  const auto worn = worn_by(archard + "  set Cycles = 2e7\n");
  const auto table = folder.write("worn.csv", rows_of(worn)).string();
  const auto on_it = worn_by(archard + "  set Cycles = 1\n  set Profile = " + table + "\n").course;
  const auto text = replace(wearing_text(""), "parabola\n  set Radius = 1e-2", "table\n  set Table = " + table);
  const auto prepared = prepare({read_case(text)}).front();
  ASSERT_FALSE(prepared.mdr.falls().empty());
  const auto alone = compute_case(prepared.fem, with_rings(prepared.fem.resolution, 0.5), shared_bodies());
  Eigen::VectorXd areas(worn.centre.size());
  for (Eigen::Index i = 0; i < areas.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    areas[i] = 3.14159265358979 * (worn.radii[k + 1] - worn.radii[k]) * (worn.radii[k + 1] + worn.radii[k]);
  }
  constexpr double force_unit = 1e6 * 1e-4 * 1e-3;  // Pa m m
  const Eigen::RowVectorXd forces = force_unit * areas.transpose() * on_it.first.pressure;
  EXPECT_NEAR(alone.normal_force_max / forces.maxCoeff(), 1, 3e-3);
  // It bears more where it is unworn.
  const auto unworn = worn_by(archard + "  set Cycles = 1\n").course;
  EXPECT_GT((force_unit * areas.transpose() * unworn.first.pressure).maxCoeff(), 1.01 * forces.maxCoeff());
}

// What slips bears mu p: k of the energy of friction is mu times that of Archard's law.
TEST(WearSimulation, ByTheEnergyOfFrictionIsArchardsWithTheCoefficientOfFriction) {
  const auto by_pressure = worn_by(archard + "  set Cycles = 1e6\n");
  const auto by_energy = worn_by("  set Law = energy\n  set Coefficient = 2e-12\n  set Cycles = 1e6\n");
  EXPECT_EQ(by_pressure.course.end, fem::WearEnd::cycles);
  EXPECT_GT(by_pressure.course.curve.back().volume, 0);
  EXPECT_NEAR(by_energy.course.curve.back().volume / by_pressure.course.curve.back().volume, 1, 1e-12);
}

// k p^m of the pressure in Pa: with the exponent 1 it is Archard's, with another one the rate is of another size.
TEST(WearSimulation, ByAPowerTakesThePressureInPascal) {
  const auto rate = [&](const std::string& law) {
    return worn_by(law + "  set Cycles = 1\n").course.curve.front().volume_rate;
  };
  const double archards = rate(archard);
  EXPECT_NEAR(rate("  set Law = power\n  set Exponent = 1\n  set Coefficient = 1e-12\n") / archards, 1, 1e-12);
  // The rings that slip bear up to 2e5 Pa: with k p^2 = 1e-12 p at 1e5 Pa.
  const double square = rate("  set Law = power\n  set Exponent = 2\n  set Coefficient = 1e-17\n") / archards;
  EXPECT_GT(square, 0.3);
  EXPECT_LT(square, 2);
}

// Under both forces the stick radius of the unworn contact is that of the worn one; the indenter sinks in on the way.
TEST(WearSimulation, EndsUnderForcesWithTheStickRadiusOfTheUnworn) {
  const auto prepared = wearing_under_force("set Tangential force amplitude = 0.06");
  const double unworn = std::cbrt(1 - 0.06 / (0.5 * 0.3));
  const auto edge = edge_of_wear(prepared.fem, *prepared.input.wear_kinetics, unworn, shared_bodies());
  EXPECT_NEAR(edge.inner, unworn, 1e-3);
  // F = 16/3 = 8 (c d - c^3/3) in units of the unworn contact; beyond it r^2/2 = d.
  const double depth = 2 / (3 * unworn) + unworn * unworn / 3;
  EXPECT_GT(edge.outer, std::sqrt(2 * depth));
  EXPECT_LT(edge.outer, 1.05 * std::sqrt(2 * depth));
}

// Nothing sticks: all that the largest indentation reaches is worn, to the plane of the apex.
TEST(WearSimulation, WearsAllOfItWhereNothingSticks) {
  const auto wear = worn_by(archard, 0, "set Tangential amplitude = 1e-4");
  EXPECT_EQ(wear.course.end, fem::WearEnd::nothing_left);
  for (Eigen::Index i = 0; i < 20; ++i) EXPECT_NEAR(wear.unworn[i] + wear.course.worn.back()[i], 1, 2e-3) << i;
  EXPECT_EQ(wear.course.curve.back().stick_radius, 0);
}

}  // namespace
}  // namespace fretval
