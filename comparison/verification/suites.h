#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/suite.h"
#include "comparison/verification/written_case.h"

namespace fretval {

/// The CI check: a few small cases on the two committed meshes of meshes/small. Each is there twice, on the coarse and
/// on the fine mesh, with the tolerances that the ring width of the mesh allows, and without error bars.
/// meshes: folder with coarse.msh and fine.msh. Throws InputError or meshes::MeshError if the files are damaged.
std::vector<SuiteCase> small_cases(const std::filesystem::path& meshes);

/// The folder of the committed meshes.
std::filesystem::path small_meshes();

SuiteRun run_small_suite(const std::filesystem::path& meshes);

/// Fifty varied cases on which the suite `tolerance` measures whether `Accuracy / Tolerance` is met, and proved: all
/// shapes with a formula, elastic to three branches, Kelvin-Voigt bodies up to omega tau = 2, locked and unlocked
/// phases, stick zones down to 0.02 a, slip annuli down to 1e-3 a, no first-slip zone, no tangential motion. The stick
/// radius of a truncated sphere is away from the edge of its flat. They were chosen before their errors were known.
std::vector<SuiteCase> tolerance_cases(double tolerance);

/// Runs the suite: all tolerance_cases() at each tolerance.
SuiteRun run_tolerance_suite(const std::vector<double>& tolerances);

/// The base of all cases: a parabola of 10 mm on a standard solid with |G|/G'(0) = 1.22, d0 = 0.1 mm, Delta d = 0.2 d0,
/// phase 60 degrees, k = 1, tolerance 1e-2.
Entries extremes_base();

/// The base of extremes_base() with an elastic body.
Entries elastic_base();

/// The cases of the suite `extremes`: families that go to the ends of one parameter each. Throws InputError if a case
/// cannot be set up.
std::vector<SuiteCase> extreme_cases();

/// The first case of each family.
std::vector<SuiteCase> short_extreme_cases();

/// The cases whose family contains a text.
std::vector<SuiteCase> only_family(const std::vector<SuiteCase>& cases, const std::string& text);

SuiteRun run_extreme_suite(const std::vector<SuiteCase>& cases);

/// Identifies a random case: the seed of the suite, the number of the case, and how many times it was drawn before
/// because the tool refused it as bad input.
struct RandomDraw {
  std::uint64_t seed;
  std::size_t number;
  int attempt = 0;
};

/// A random case, the same for the same draw on every machine. Drawn are
///
///   lengths 1 nm to 1 m, depths 1e-3 to 0.3 of the contact radius, moduli 1 mPa to 1 TPa, 1e-6 to 1e6 Hz;
///   every shape with a formula: parabola, sphere, cone, r^1.2 to r^8, rounded flat, truncated sphere;
///   half-spaces, and bonded layers of a/H about 0.05 to 3 in a quarter of the motions that soon repeat; Poisson's
///   ratios of 0 to 0.49 in a quarter;
///   every rheology but a table: branches of 0.01 to 100 G0 and omega tau = 1e-3 to 1e3, dashpots up to
///   omega eta = 10 G0, fractional orders 0.1 to 1;
///   mu = 0.01 to 10; Delta d/d0 = 0, 1e-3 to 1, 1 but for 1e-6, up to 3; any phase, 0 to 1e-6 deg, unlocked;
///   tangential amplitudes of nothing, full stick, any stick radius from 1e-4 a to (1 - 1e-6) a, the border of no stick
///   to 1e-9, gross slip;
///   limiting profiles of c/a = 0.25, 0.5 and 0.75 (one body each);
///   a tenth of the motions that soon repeat under a normal force, a tenth under a tangential one.
///
/// Cases that finite elements refuse by name are not drawn.
Entries random_entries(const RandomDraw& draw);

struct RandomSuiteOptions {
  std::uint64_t seed;
  std::size_t n_cases = 10000;
  std::optional<std::size_t> only = {};  ///< the number of the one case that is to be run, from 0
  bool with_cycle = false;               ///< see SuiteCase::with_cycle
};

/// Random cases on one coarse discretisation, each with its error bars (Proof::bars) but without any refinement. Bars
/// may be wider than the tolerance, and are infinite where a coarser computation lacks the quantity; errors have to be
/// within them. A case that the tool refuses as bad input (InputError) is drawn again, at most 100 times; nothing else
/// is left out.
SuiteRun run_random_suite(const RandomSuiteOptions& options);

}  // namespace fretval
