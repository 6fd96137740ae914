#include "comparison/verification/random_cases/random_cases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparison/reference/mdr_case.h"
#include "comparison/support/random_numbers.h"

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;

// Relaxation time, and modulus over G0 times relaxation time, of a branch: omega tau. 16 cycles.
constexpr double most_creep = 100;

/// Sizes that a case is made from.
struct Scale {
  double length, depth, modulus, frequency;

  [[nodiscard]] double time() const { return 1 / (2 * pi * frequency); }
};

/// Six digits: short case files, and roundoff of a library's exp and log does not show.
std::string short_text(double value) {
  return fmt::format("{:.6g}", value);
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
  switch (random.weighted({3, 2, 3, 1.5, 1.5})) {
    case 0:
      return {{"Indenter / Shape", "parabola"}, {"Indenter / Radius", short_text(radius)}};
    case 1: {
      const double degrees = std::atan(2 * scale.depth / (pi * scale.length)) * 180 / pi;
      return {{"Indenter / Shape", "cone"}, {"Indenter / Slope angle", short_text(degrees)}};
    }
    case 2: {
      const std::string exponent = short_text(draw_exponent(random));
      return {{"Indenter / Shape", "power"},
              {"Indenter / Exponent", exponent},
              {"Indenter / Coefficient", short_text(scale.depth / std::pow(scale.length, std::stod(exponent)))}};
    }
    case 3:
      return {{"Indenter / Shape", "rounded flat"},
              {"Indenter / Flat radius", short_text(scale.length * random.uniform(0.05, 0.95))},
              {"Indenter / Edge radius", short_text(radius * random.log_uniform(0.1, 10))}};
    default:
      return {{"Indenter / Shape", "truncated sphere"},
              {"Indenter / Flat radius", short_text(scale.length * random.uniform(0.05, 0.95))},
              {"Indenter / Radius", short_text(radius * random.log_uniform(0.1, 10))}};
  }
}

/// Branches of a body in units of the scale. stiffest: of a branch, over the relaxed modulus; less for slow ones, so
/// that no branch makes the body creep for more than most_creep.
Entries draw_branches(RandomNumbers& random, const Scale& scale, std::size_t n, double stiffest = 100) {
  std::vector<std::string> moduli, times;
  for (std::size_t k = 0; k < n; ++k) {
    const double time = random.log_uniform(1e-3, most_creep);
    times.push_back(short_text(scale.time() * time));
    moduli.push_back(short_text(scale.modulus * random.log_uniform(1e-2, std::min(stiffest, most_creep / time))));
  }
  return {{"Elastomer / Branch moduli", fmt::format("{}", fmt::join(moduli, ", "))},
          {"Elastomer / Branch times", fmt::format("{}", fmt::join(times, ", "))}};
}

std::string draw_viscosity(RandomNumbers& random, const Scale& scale) {
  return short_text(scale.modulus * scale.time() * random.log_uniform(1e-3, 10));
}

Entries draw_elastomer(RandomNumbers& random, const Scale& scale) {
  const Entries relaxed{{"Elastomer / Relaxed shear modulus", short_text(scale.modulus)}};
  switch (random.weighted({2, 2.5, 1.5, 3, 1})) {
    case 0:
      return with(relaxed, {{"Elastomer / Rheology", "elastic"}});
    case 1:
      return with(with(relaxed, draw_branches(random, scale, 1)), {{"Elastomer / Rheology", "standard solid"}});
    case 2:
      return with(relaxed,
                  {{"Elastomer / Rheology", "kelvin voigt"}, {"Elastomer / Viscosity", draw_viscosity(random, scale)}});
    case 3: {
      const std::size_t n_branches = 1 + random.index(4);
      const auto body =
          with(with(relaxed, draw_branches(random, scale, n_branches)), {{"Elastomer / Rheology", "prony"}});
      return random.chance(0.3) ? with(body, {{"Elastomer / Viscosity", draw_viscosity(random, scale)}}) : body;
    }
    default:
      // Its spectrum reaches a hundred times beyond a cycle, whatever its time.
      return with(with(relaxed, draw_branches(random, scale, 1, 1)),
                  {{"Elastomer / Rheology", "fractional zener"},
                   {"Elastomer / Fractional order", short_text(random.uniform(0.1, 1))}});
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
      return short_text(random.one_of<double>({0, 90, 180, -90}));
    case 2: {
      const double near = random.one_of<double>({0, 180}), sign = random.one_of<double>({-1, 1});
      return entry_text(near + sign * random.log_uniform(1e-6, 1));
    }
    default:
      return short_text(random.uniform(-180, 360));
  }
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
  const auto still = with(entries, {{"Motion / Normal amplitude", "0"}, {"Motion / Tangential amplitude", "0"}});
  const auto mdr = mdr_case(case_of(still, "case"));
  return mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal_frequency));
}

}  // namespace

Entries random_entries(const RandomDraw& draw) {
  RandomNumbers random({draw.seed, draw.number, static_cast<std::uint64_t>(draw.attempt)});
  const auto scale = draw_scale(random);
  Entries entries{{"Accuracy / Tolerance", "1e-2"},
                  {"Accuracy / Rings per radius", "32"},
                  {"Accuracy / Steps per cycle", "32"},
                  {"Friction / Law", "unidirectional"}};
  entries = with(entries, draw_indenter(random, scale));
  entries = with(entries, draw_elastomer(random, scale));
  const double friction = random.log_uniform(0.01, 10);
  entries = with(entries, {{"Friction / Coefficient", short_text(friction)},
                           {"Motion / Indentation", short_text(scale.depth)},
                           {"Motion / Normal frequency", short_text(scale.frequency)},
                           {"Motion / Tangential frequency", short_text(scale.frequency)},
                           {"Motion / Phase", draw_phase(random)}});
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
  return with_tangential_amplitude(random, entries, 1.5 * friction * scale.depth / stiffening,
                                   stiffening * normal_ratio);
}

}  // namespace fretval
