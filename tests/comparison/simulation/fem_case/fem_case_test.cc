#include "comparison/simulation/fem_case/fem_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "comparison/accuracy/prepared_case.h"
#include "fem/support/constants.h"
#include "tests/comparison/computed_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/wearing_case.h"

namespace fretval {
namespace {

// A case is made dimensionless before anything is computed, so units only change by roundoff.
TEST(FemCase, IsTheSameInMetresAndInNanometres) {
  const Case large = read_case();
  Case small = large;
  const double scale = 1e-9;
  small.indenter.radius *= scale;
  small.motion.indentation *= scale;
  small.motion.normal_amplitude *= scale;
  small.motion.tangential_amplitude *= scale;
  const auto a = simulate_case(large), b = simulate_case(small);
  EXPECT_NEAR(*b.stick_radius_shakedown / (scale * *a.stick_radius_shakedown), 1, 1e-11);
  EXPECT_NEAR(*b.stick_radius_first_slip / (scale * *a.stick_radius_first_slip), 1, 1e-11);
  EXPECT_NEAR(b.normal_force_max / (scale * scale * a.normal_force_max), 1, 1e-11);
}

// Rings of equal width, of a body that is scaled: the contact radius, 1, lies where it is asked for in its ring.
TEST(FemCase, EdgeLiesElsewhereInItsRing) {
  const auto input = read_case();
  const auto fem = prepare({input}).front().fem;
  auto resolution = fem.resolution;
  for (const double before_node : {usual_edge_before_node, 0.25, 0.5}) {
    resolution.edge_before_node = before_node;
    const auto body = at_resolution(fem, resolution).body;
    const double rings = 1 / (body.scale * (body.contact_nodes[1] - body.contact_nodes[0]));
    EXPECT_NEAR(std::ceil(rings) - rings, before_node, 1e-9);
  }
}

// Steps that begin later belong to the same motion, however often a case is taken to another resolution.
TEST(FemCase, StepsBeginLaterInTheSameMotion) {
  auto input = read_case();
  input.motion.tangential_frequency = 2 * input.motion.normal_frequency;
  const auto fem = prepare({input}).front().fem;
  auto later = fem.resolution;
  later.first_step = 0.5;
  const auto shifted = at_resolution(at_resolution(fem, with_steps(later, 0.5)), later);
  const double angle = 0.5 * 2 * fem::pi / fem.steps_per_cycle();
  const double after_ramp = 2 * fem::pi * (fem.resolution.n_ramp_cycles + 1);
  for (const double t : {after_ramp, after_ramp + 1, after_ramp + 2.5}) {
    EXPECT_NEAR(fem::normal_motion(shifted.motion, t).value, fem::normal_motion(fem.motion, t + angle).value, 1e-12);
    EXPECT_NEAR(fem::tangential_motion(shifted.motion, t).value, fem::tangential_motion(fem.motion, t + angle).value,
                1e-12);
  }
  const auto back = at_resolution(shifted, fem.resolution);
  EXPECT_NEAR(fem::tangential_motion(back.motion, after_ramp).value,
              fem::tangential_motion(fem.motion, after_ramp).value, 1e-12);
}

/// The case with a layer in the place of the half-space.
Case on_layer(double thickness) {
  auto input = read_case();
  input.body.shape = Case::Body::Shape::layer;
  input.body.thickness = thickness;
  return input;
}

// A layer has a length. Its own rings are moved, by what coarser rings tell of it that its error bars ask for anyway.
TEST(FemCase, EdgeLiesElsewhereInMovedRingsOfALayer) {
  const auto fem = prepare({on_layer(3e-3)}).front().fem;
  auto resolution = fem.resolution;
  resolution.edge_before_node += 0.5;
  const auto body = at_resolution(fem, resolution).body;
  ASSERT_TRUE(body.has_moved_rings());
  EXPECT_EQ(body.contact_nodes, fem.body.contact_nodes);
  EXPECT_EQ(body.scale, 1);
  const double rings = 1 / (body.moved.factor * body.contact_nodes[1]);
  EXPECT_NEAR(std::ceil(rings) - rings, usual_edge_before_node + 0.5, 1e-9);
  const auto coarse = at_resolution(fem, with_rings(fem.resolution, 0.5)).body;
  EXPECT_EQ(body.moved.coarse_nodes, coarse.contact_nodes);
  EXPECT_EQ(body.moved.coarse_far_radius, coarse.far_radius);
  EXPECT_FALSE(fem.body.has_moved_rings());
}

// On a layer of two coarse rings, and for the full contact, a body of the moved rings is made.
TEST(FemCase, EdgeLiesElsewhereOnABodyOfItsOwn) {
  auto full = on_layer(3e-3);
  full.contact.vector_friction = true;
  for (const auto& input : {on_layer(4e-4), full}) {
    const auto fem = prepare({input}).front().fem;
    auto resolution = fem.resolution;
    resolution.edge_before_node += 0.5;
    const auto body = at_resolution(fem, resolution).body;
    EXPECT_FALSE(body.has_moved_rings());
    EXPECT_GT(body.contact_nodes.back(), fem.body.contact_nodes.back());
    EXPECT_EQ(body.thickness, fem.body.thickness);
  }
}

// An unlocked phase passes through every phase, so its stick radius is the smallest of all of them, paper (21).
TEST(FemCase, UnlockedPhaseFollowsTheWorstPhase) {
  Case input = read_case();
  input.motion.phase.reset();
  const auto answer = exact_answer(input);
  const auto fe = simulate_case(input);
  // Measured 1.3e-3 at this coarse tolerance of 1e-2; a locked phase of 90 degrees is 0.2 a away.
  EXPECT_NEAR(*fe.stick_radius_shakedown, *answer.stick_radius_shakedown, 5e-3 * answer.contact_radius_max.value());
  EXPECT_NEAR(*fe.stick_radius_first_slip, *answer.stick_radius_first_slip, 5e-3 * answer.contact_radius_max.value());
}

// What moves in one direction alone has no phase that could drift.
TEST(FemCase, AnUnlockedPhaseNeedsMotionInBothDirections) {
  Case input = read_case();
  input.motion.phase.reset();
  const auto is_locked = [&] { return prepare({input}).front().fem.motion.locked; };
  EXPECT_FALSE(is_locked());
  const double amplitude = std::exchange(input.motion.normal_amplitude, 0);
  EXPECT_TRUE(is_locked());
  input.motion.normal_amplitude = amplitude;
  input.motion.tangential_amplitude = 0;
  EXPECT_TRUE(is_locked());
}

/// The motion of a case as a table of so many rows a period.
Case sampled(Case input, int n_rows) {
  auto& motion = input.motion;
  motion.path = Case::Path{};
  auto& path = *motion.path;
  path.file = "sampled.csv";
  path.repeats = true;
  const double pi = std::acos(-1.0), phase = *motion.phase * pi / 180;
  for (int k = 0; k <= n_rows; ++k) {
    const double angle = 2 * pi * k / n_rows;
    path.time.push_back(static_cast<double>(k) / n_rows / motion.normal_frequency);
    path.normal.push_back(motion.indentation + motion.normal_amplitude * std::cos(angle));
    path.tangential.push_back(motion.tangential_amplitude * std::cos(angle + phase));
  }
  return input;
}

// Chords of a cosine: of second order in the rows.
TEST(FemCase, ASampledMotionTendsToTheMotion) {
  Case input = read_case(elastic_case());
  input.tolerance = 1e-3;
  input.motion.phase = 40;  // what limits the stick zone is largest between two rows, at a third of their distance
  const auto answer = exact_answer(input);
  const auto error = [&](int n_rows) {
    return *simulate_case(sampled(input, n_rows)).stick_radius_shakedown / *answer.stick_radius_shakedown - 1;
  };
  const double coarse = error(12), fine = error(24);
  EXPECT_GT(std::abs(coarse), 1e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
}

TEST(FemCase, RefusesAPathOfTooManyRows) {
  const Case input = sampled(read_case(elastic_case()), 2000);
  expect_parts(refusal([&] { prepare({input}); }), {"sampled.csv: has 2001 rows", "2000 at most", "fretval mdr"});
}

// Two frequencies, and a second harmonic of either, whose cycle does not begin with the first one's: both closed
// formulas of the reference, and the largest force of its springs.
TEST(FemCase, SeveralHarmonicsFollowTheReference) {
  for (const auto& [normal, tangential] : {std::pair(1.0, 2.0), {3.0, 2.0}}) {
    Case input = read_case();
    input.motion.normal_frequency = normal;
    input.motion.tangential_frequency = tangential;
    input.motion.normal_harmonics = {{6e-6, 2 * normal, 100}};
    input.motion.tangential_harmonics = {{4e-6, 2 * tangential, -50}};
    const auto answer = exact_answer(input);
    const auto fe = simulate_case(input);
    const double a = answer.contact_radius_max.value();
    EXPECT_NEAR(fe.contact_radius_max.value(), a, 2e-3 * a);
    EXPECT_NEAR(fe.stick_radius_shakedown.value(), answer.stick_radius_shakedown.value(), 5e-3 * a);
    EXPECT_NEAR(fe.stick_radius_first_slip.value(), answer.stick_radius_first_slip.value(), 5e-3 * a);
    EXPECT_NEAR(fe.normal_force_max / answer.normal_force_max.value(), 1, 2e-3);
    EXPECT_GT(answer.stick_radius_shakedown.value() - answer.stick_radius_first_slip.value(), 1e-3 * a);
  }
}

// A tangential motion that is far faster than the normal one is brought close to it, with the forces of its own
// displacement; what wears, wears by that displacement, as often as it comes.
TEST(FemCase, WearsByTheDisplacementsOfTheMotionItself) {
  Case input = read_case();
  input.motion.tangential_frequency = 300.4 * input.motion.normal_frequency;
  const auto oscillation_of = [](const Case& one) { return prepare({one}).front().fem.motion.tangential.at(0); };
  const auto scaled = oscillation_of(input);
  EXPECT_LT(scaled.order, 96);
  input.wear_kinetics = Case::WearKinetics{};
  const auto kept = oscillation_of(input);
  EXPECT_EQ(kept.order, 300);
  EXPECT_NEAR(kept.amplitude,
              input.motion.tangential_amplitude / (input.motion.indentation + input.motion.normal_amplitude), 1e-12);
  EXPECT_GT(scaled.amplitude, 1.01 * kept.amplitude);
}

// The pressure of a body with a dashpot jumps at the edge of the contact, so the gaps beyond it have to tell where it
// ends. On a contact line with fewer than three rings beyond, the force was 3e-3 off at 8, 12 and 16 rings alike,
// and 2e-4 at 16 rings with them.
TEST(FemCase, RingsBeyondTheContactTellWhereItEnds) {
  const auto input = fixed_case("parabola-voigt-90", 16, 48);
  EXPECT_NEAR(simulate_case(input).normal_force_max / exact_answer(input).normal_force_max.value(), 1, 5e-4);
}

// f = R - sqrt(R² - r²) in units of the depth, and of the contact radius a with (a/2) ln((R+a)/(R-a)) = d.
TEST(FemCase, SphereHasItsTrueArc) {
  const auto prepared_sphere = [](double radius) {
    Case input = read_case(replace(valid_case, "Shape = parabola", "Shape = sphere"));
    input.indenter.radius = radius;
    return prepare({input}).front();
  };
  const double R = 1e-3;
  const auto fem = prepared_sphere(R).fem;
  const double a = fem.units.length, d = fem.units.depth;
  EXPECT_NEAR(d, 1.2e-4, 1e-18);
  EXPECT_NEAR(a / 2 * std::log((R + a) / (R - a)) / d, 1, 1e-12);
  for (const double r : {0.2, 0.7, 1.1}) EXPECT_NEAR(fem.profile(r) * d, R - std::sqrt(R * R - r * r * a * a), 1e-15);
  // a/R = 0.64 and 0.69.
  EXPECT_NO_THROW(prepared_sphere(1.2e-4 / (0.64 * std::atanh(0.64))));
  expect_parts(refusal([&] { prepared_sphere(1.2e-4 / (0.69 * std::atanh(0.69))); }),
               {"case.prm", "Indenter / Radius = 0.000205", "contact radius is 0.000142 m", "at least 0.000212 m",
                "`fretval mdr` answers"});
}

// The widest rings of a coarse mesh may reach beyond it: nothing touches there, and no height is undefined.
TEST(FemCase, ContinuesASphereBeyondItsEquator) {
  auto input = read_case(replace(valid_case, "Shape = parabola", "Shape = sphere"));
  input.indenter.radius = 1.2e-4 / (0.6 * std::atanh(0.6));
  const auto fem = prepare({input}).front().fem;
  const double equator = input.indenter.radius / fem.units.length;
  const auto height = [&](double r) { return fem.profile(r) * fem.units.depth / input.indenter.radius; };
  constexpr double steep = 1e-7;  // the root of a roundoff
  EXPECT_NEAR(height(equator), 1, steep);
  EXPECT_EQ(height(1.1 * equator), 1);
  EXPECT_EQ(height(2 * equator), 1);
}

// Parabola of 10 mm, 0.1 mm deep: a = 1 mm.
TEST(FemCase, WearGoesOnFromATableOfHeightsOrOfRings) {
  const ScratchFolder folder;
  const auto worn_by = [&](const std::string& entry, const std::string& rows) {
    const auto table = folder.write("worn.csv", rows).string();
    return wearing_case("  set Coefficient = 1e-12\n  set " + entry + " = " + table + "\n").fem.worn_before.value();
  };
  EXPECT_NEAR(worn_by("Profile", "r [mm],f [mm]\n0,0\n0.5,0.0125\n0.7,0.0255\n0.8,0.0325\n").depth(0.75), 0.0075, 1e-9);
  EXPECT_NEAR(worn_by("Worn rings", "r outer [mm],worn depth [um]\n0.5,0\n0.8,2\n").depth(0.75), 0.02, 1e-12);
  EXPECT_FALSE(wearing_case("  set Coefficient = 1e-12\n").fem.worn_before);
}

}  // namespace
}  // namespace fretval
