#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/support/constants.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/progress.h"
#include "comparison/support/random_numbers.h"
#include "comparison/support/statistics.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/suites.h"
#include "comparison/verification/written_case.h"
#include "mdr/motion/commensurability.h"

namespace fretval {
namespace {

// Relaxation time, and modulus over G0 times relaxation time, of a branch: omega tau. 16 cycles.
constexpr double most_creep = 100;

/// Sizes that a case is made from.
struct Scale {
  double length, depth, modulus, frequency;

  [[nodiscard]] double time() const { return 1 / (2 * pi * frequency); }
};

/// A value to six digits: case files are short, and the roundoff of a library's exp and log does not show.
double rounded(double value) {
  return to_digits(value, 6);
}

Scale draw_scale(RandomNumbers& random) {
  Scale scale{};
  scale.length = random.log_uniform(1e-9, 1);
  scale.depth = scale.length * random.log_uniform(1e-3, 0.3);
  scale.modulus = random.log_uniform(1e-3, 1e12);
  scale.frequency = random.log_uniform(1e-6, 1e6);
  return scale;
}

double draw_exponent(RandomNumbers& random) {
  return random.chance(0.3) ? random.one_of<double>({1.5, 3, 4, 6, 8}) : random.log_uniform(1.2, 8);
}

/// Shapes whose contact radius at the depth is about the length.
Entries draw_indenter(RandomNumbers& random, const Scale& scale) {
  const double radius = scale.length * scale.length / scale.depth;
  const auto shape = random.weighted({3, 2, 3, 1.5, 1.5, 1});
  if (shape == 0) return parabola(rounded(radius));
  if (shape == 1) return cone(rounded(std::atan(2 * scale.depth / (pi * scale.length)) * 180 / pi));
  if (shape == 2) {
    const double exponent = rounded(draw_exponent(random));
    return power(exponent, rounded(scale.depth / std::pow(scale.length, exponent)));
  }
  if (shape == 5) return sphere(rounded(radius));
  const double flat = rounded(scale.length * random.uniform(0.05, 0.95));
  const double rest = rounded(radius * random.log_uniform(0.1, 10));
  return shape == 3 ? rounded_flat(flat, rest) : truncated_sphere(rest, flat);
}

/// Branches in units of the scale. stiffest: of a branch, over the relaxed modulus; less for slow ones, so that no
/// branch makes the body creep for more than most_creep.
Entries draw_branches(RandomNumbers& random, const Scale& scale, const char* rheology, std::size_t n,
                      double stiffest = 100) {
  std::vector<double> moduli, times;
  for (std::size_t k = 0; k < n; ++k) {
    const double time = random.log_uniform(1e-3, most_creep);
    times.push_back(rounded(scale.time() * time));
    moduli.push_back(rounded(scale.modulus * random.log_uniform(1e-2, std::min(stiffest, most_creep / time))));
  }
  return branches(rheology, rounded(scale.modulus), moduli, times);
}

Entries draw_elastomer(RandomNumbers& random, const Scale& scale) {
  const auto draw_viscosity = [&] { return rounded(scale.modulus * scale.time() * random.log_uniform(1e-3, 10)); };
  switch (random.weighted({2, 2.5, 1.5, 3, 1})) {
    case 0:
      return elastic(rounded(scale.modulus));
    case 1:
      return draw_branches(random, scale, "standard solid", 1);
    case 2:
      return kelvin_voigt(rounded(scale.modulus), draw_viscosity());
    case 3: {
      const std::size_t n_branches = 1 + random.index(4);
      const auto body = draw_branches(random, scale, "prony", n_branches);
      return random.chance(0.3) ? with_numbers(body, {{"Elastomer / Viscosity", draw_viscosity()}}) : body;
    }
    default: {
      // The spectrum of a fractional body reaches to a hundred times a cycle, whatever its relaxation time.
      const double order = rounded(random.uniform(0.1, 1));
      return with_numbers(draw_branches(random, scale, "fractional zener", 1, 1),
                          {{"Elastomer / Fractional order", order}});
    }
  }
}

/// Delta d/d0.
double draw_normal_ratio(RandomNumbers& random) {
  switch (random.weighted({1, 5, 2, 0.7, 0.7})) {
    case 0:
      return 0;
    case 1:
      return random.log_uniform(1e-3, 0.3);
    case 2:
      return random.uniform(0, 1);
    case 3:
      return 1 - random.log_uniform(1e-6, 0.1);
    default:
      return random.uniform(1, 3);
  }
}

std::string draw_phase(RandomNumbers& random) {
  switch (random.weighted({0.6, 1.5, 0.8, 7.1})) {
    case 0:
      return "free";
    case 1:
      return entry_text(random.one_of<double>({0, 90, 180, -90}));
    case 2: {
      const double near = random.one_of<double>({0, 180}), sign = random.one_of<double>({-1, 1});
      return entry_text(near + sign * random.log_uniform(1e-6, 1));
    }
    default:
      return entry_text(rounded(random.uniform(-180, 360)));
  }
}

/// f_x/f_z.
double draw_frequency_ratio(RandomNumbers& random) {
  if (random.chance(0.8)) return 1;
  const double golden = (1 + std::sqrt(5)) / 2;
  return random.one_of<double>({1.0 / 2, 2, 2.0 / 3, 3.0 / 2, 5.0 / 7, 7.0 / 5, 1.001, golden});
}

/// A second or third harmonic of a direction that moves, in some cases.
Entries with_harmonic(RandomNumbers& random, Entries entries, const std::string& direction) {
  const double amplitude = std::stod(entries.at("Motion / " + direction + " amplitude")),
               frequency = std::stod(entries.at("Motion / " + direction + " frequency"));
  if (!random.chance(0.07)) return entries;
  entries["Motion / " + direction + " harmonics"] =
      fmt::format("{}, {}, {}", entry_text(rounded(amplitude * random.uniform(0.05, 0.5))),
                  entry_text(frequency * random.one_of<double>({2, 3})), entry_text(rounded(random.uniform(0, 360))));
  return entries;
}

/// Entries with the amplitude that shakes down at a stick radius; the same entries if none does, because the contact
/// opens inside it in every cycle.
Entries with_stick_ratio_if_any(const Entries& entries, double stick_ratio, double factor = 1) {
  try {
    return with_stick_ratio(entries, stick_ratio, factor);
  } catch (const InputError&) {
    return entries;
  }
}

/// sliding: the tangential amplitude at which a contact at rest in the normal direction just slides; normal_ratio:
/// |G|/G'(0) Delta d/d0.
Entries with_tangential_amplitude(RandomNumbers& random, Entries entries, double sliding, double normal_ratio) {
  const auto amplitude = [&](double load) { entries["Motion / Tangential amplitude"] = entry_text(load * sliding); };
  amplitude(random.log_uniform(1e-2, 10));
  switch (random.weighted({0.3, 5, 0.8, 0.8, 0.8, 1, 0.5, 1.5})) {
    case 0:
      amplitude(0);
      return entries;
    case 1:
      return with_stick_ratio_if_any(entries, random.uniform(0, 1));
    case 2:
      return with_stick_ratio_if_any(entries, random.log_uniform(1e-4, 0.1));
    case 3:
      return with_stick_ratio_if_any(entries, 1 - random.log_uniform(1e-6, 0.1));
    case 4: {
      const double sign = random.one_of<double>({-1, 0, 1});
      return with_stick_ratio_if_any(entries, 0, 1 + sign * random.log_uniform(1e-9, 1e-2));
    }
    case 5:
      amplitude(random.log_uniform(1e-6, 0.1));
      return entries;
    case 6:
      amplitude(random.log_uniform(1, 100));
      return entries;
    default:
      if (normal_ratio > 0) amplitude(normal_ratio / random.log_uniform(0.05, 20));
      return entries;
  }
}

/// |G(omega)|/G'(0) of a case without motion yet.
double modulus_ratio_of(const Entries& entries) {
  const auto still = with_numbers(entries, {{"Motion / Normal amplitude", 0}, {"Motion / Tangential amplitude", 0}});
  const auto mdr = mdr_case(case_of(still, "case"));
  return mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal.front().frequency));
}

/// Whether the motion repeats after a few oscillations.
bool has_short_cycle(const Entries& entries) {
  constexpr int few = 10;
  const auto ratio = mdr::frequency_ratio(std::stod(entries.at("Motion / Tangential frequency")) /
                                          std::stod(entries.at("Motion / Normal frequency")));
  return entries.at("Motion / Phase") != "free" && ratio && std::max(ratio->numerator, ratio->denominator) <= few;
}

/// Another body than an incompressible half-space, in some cases. Springs of a layer go through a long cycle for
/// minutes.
Entries with_body(RandomNumbers& random, Entries entries, const Scale& scale) {
  if (random.chance(0.25))
    entries["Elastomer / Poisson ratio"] = entry_text(random.one_of<double>({0, 0.2, 0.4, 0.49}));
  if (!random.chance(0.25) || !has_short_cycle(entries)) return entries;
  return with_numbers(with(entries, {{"Body / Shape", "layer"}, {"Body / Base", "bonded"}}),
                      {{"Body / Thickness", rounded(scale.length * random.log_uniform(0.3, 20))}});
}

/// Forces in the place of displacements, in some cases: those of a contact of the size of the scale. Histories under
/// them, too, go through a long cycle for minutes. normal_ratio: |G|/G'(0) Delta d/d0.
Entries with_forces(RandomNumbers& random, Entries entries, const Scale& scale, double friction, double normal_ratio) {
  const double force = rounded(4 * scale.modulus * scale.length * scale.depth * random.log_uniform(0.2, 2));
  const bool repeats = has_short_cycle(entries), normally = random.chance(0.1) && repeats,
             tangentially = random.chance(0.1) && repeats;
  if (normally) {
    for (const char* name : {"Indentation", "Normal amplitude", "Normal harmonics"})
      entries.erase(std::string("Motion / ") + name);
    entries =
        with_numbers(entries, {{"Motion / Normal force", force},
                               {"Motion / Normal force amplitude", rounded(std::min(normal_ratio, 0.95) * force)}});
  }
  if (!tangentially) return entries;
  for (const char* name : {"Tangential amplitude", "Tangential harmonics"})
    entries.erase(std::string("Motion / ") + name);
  return with_numbers(entries,
                      {{"Motion / Tangential force amplitude", rounded(friction * force * random.uniform(0, 0.9))}});
}

constexpr int most_attempts = 100;

std::string family_of(const Entries& entries) {
  return fmt::format("{}{}, {}", entries.count("Wear / State") > 0 ? "worn " : "", entries.at("Indenter / Shape"),
                     entries.at("Elastomer / Rheology"));
}

/// Draws until the tool takes the case. What else may be wrong with it, its row will say.
SuiteCase drawn_case(std::uint64_t seed, std::size_t number) {
  SuiteCase one{"", fmt::format("random-{}-{}", seed, number)};
  one.proof = Proof::bars;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    try {
      const auto entries = random_entries({seed, number, attempt});
      one.family = family_of(entries);
      one.text = case_text(entries);
      prepare({case_of(one)});
      return one;
    } catch (const InputError&) {
      // drawn again
    } catch (const std::exception&) {
      return one;
    }
  }
  return one;
}

/// Tells how far it is, on a terminal from the first second on: the tool reads every case that it draws.
std::vector<SuiteCase> drawn_cases(const RandomSuiteOptions& options) {
  const std::size_t first = options.only.value_or(0);
  std::vector<SuiteCase> cases(options.only ? 1 : options.n_cases);
  constexpr std::size_t many = 1000;
  if (cases.size() >= many) log::info(fmt::format("drawing {} cases", cases.size()));
  Progress progress(1);
  std::atomic<std::size_t> n_drawn{0};
  for_each_in_parallel(cases.size(), [&](std::size_t i) {
    cases[i] = drawn_case(options.seed, first + i);
    cases[i].with_cycle = options.with_cycle;
    const auto n = ++n_drawn;
    progress.under_way("cases", static_cast<double>(n) / static_cast<double>(cases.size()),
                       fmt::format("{} of {} drawn", n, cases.size()));
  });
  return cases;
}

}  // namespace

Entries random_entries(const RandomDraw& draw) {
  RandomNumbers random({draw.seed, draw.number, static_cast<std::uint64_t>(draw.attempt)});
  const auto scale = draw_scale(random);
  Entries entries = draw_indenter(random, scale);
  entries.merge(draw_elastomer(random, scale));
  const double friction = random.log_uniform(0.01, 10);
  entries = with_numbers(with(entries, {{"Friction / Law", "unidirectional"}, {"Motion / Phase", draw_phase(random)}}),
                         {{"Accuracy / Tolerance", 1e-2},
                          {"Accuracy / Rings per radius", 32},
                          {"Accuracy / Steps per cycle", 32},
                          {"Friction / Coefficient", rounded(friction)},
                          {"Motion / Indentation", rounded(scale.depth)},
                          {"Motion / Normal frequency", rounded(scale.frequency)},
                          {"Motion / Tangential frequency", draw_frequency_ratio(random) * rounded(scale.frequency)}});
  // A body that is stiff in motion loses contact at small amplitudes.
  const double stiffening = modulus_ratio_of(entries);
  const bool flat = entries.count("Indenter / Flat radius") > 0, worn = random.chance(0.03) && !flat;
  double normal_ratio = worn ? random.log_uniform(1e-3, 0.2) : draw_normal_ratio(random);
  if (random.chance(0.8)) normal_ratio /= stiffening;
  entries["Motion / Normal amplitude"] = entry_text(normal_ratio * scale.depth);
  if (worn)
    return with(entries, {{"Wear / State", "limiting"},
                          {"Wear / Stick radius ratio", random.one_of<std::string>({"0.25", "0.5", "0.75"})},
                          {"Motion / Tangential amplitude", "shakedown"}});
  entries =
      with_tangential_amplitude(random, entries, 1.5 * friction * scale.depth / stiffening, stiffening * normal_ratio);
  entries = with_harmonic(random, with_harmonic(random, entries, "Normal"), "Tangential");
  return with_forces(random, with_body(random, entries, scale), scale, friction, stiffening * normal_ratio);
}

SuiteRun run_random_suite(const RandomSuiteOptions& options) {
  Stopwatch watch;
  SuiteRun run{"random", fmt::format("Random cases of seed {} on one coarse mesh, with their error bars but without "
                                     "any refinement.",
                                     options.seed)};
  const auto cases = drawn_cases(options);
  BodyStore bodies;
  run.rows = run_cases(cases, bodies);
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
