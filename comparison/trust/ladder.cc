#include "comparison/trust/ladder.h"

#include <fmt/format.h>

#include <cmath>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/results/answer_text.h"
#include "comparison/support/log.h"
#include "fem/support/solver_error.h"

namespace fretval {
namespace {

constexpr double incompressible = 0.5;

std::string title_of(const Case::Body& body) {
  const auto length = [](double value) {
    const auto [prefix, factor] = prefix_for(value);
    return fmt::format("{:g} {}m", value / factor, prefix);
  };
  if (body.grid) return fmt::format("the body of the mesh {}", body.mesh);
  const char* slides = body.is_bonded ? "" : " on a frictionless base";
  if (body.shape == Case::Body::Shape::cylinder)
    return fmt::format("a cylinder {} thick, of radius {}{}", length(body.thickness), length(body.radius), slides);
  return fmt::format("a layer {} thick{}", length(body.thickness), slides);
}

std::string title_of_ratio(double poisson_ratio) {
  return fmt::format("nu = {:g}", poisson_ratio);
}

/// Whether MDR's relative error in a quantity has a meaning: not in ratios, not in the force that slip has locked in,
/// and not in how the motion settles.
bool is_on_ladder(Quantity quantity) {
  const auto& traits = traits_of(quantity);
  return *traits.unit && !traits.of_settling && quantity != Quantity::tangential_force_mean;
}

/// How normal and tangential displacements of the surface couple, over the normal ones, at a wave number of 1/a, of a
/// layer bonded to its base or of a half-space (docs/theory.md).
double coupling_of(const Case& input, double contact_radius) {
  const double nu = input.elastomer.poisson_ratio, stiff = 3 - 4 * nu, kappa = input.body.thickness / contact_radius;
  constexpr double deep = 15;
  if (input.body.is_half_space() || kappa > deep) return (1 - 2 * nu) / (2 * (1 - nu));
  const double s = std::sinh(kappa), c = std::cosh(kappa);
  return std::abs((1 - 2 * nu) * stiff * s * s - kappa * kappa) / (2 * (1 - nu) * (stiff * s * c - kappa));
}

/// The answer of finite elements to a rung.
struct Proved {
  ProvedAnswer fe;
  Units units;
  /// The readings, with the error bars as uncertainties.
  [[nodiscard]] Readings readings() const {
    auto all = readings_of(fe.fe, units);
    const auto scales = scales_of(fe.fe, units);
    for (auto& [quantity, reading] : all)
      if (const auto bar = fe.budget.find(quantity); bar != fe.budget.end() && reading.value)
        reading.uncertainty = bar->second.total() * scale_of(quantity, scales, *reading.value);
    return all;
  }
};

Proved proved(const Rung& rung, BodyStore& bodies) {
  log::info(fmt::format("{}: {}", rung.input.name, rung.title));
  const auto prepared = prepare({rung.input}).front();
  auto fe = prove(prepared, Proof::tolerance, bodies);
  if (!fe.failure.empty()) throw fem::SolverError(fmt::format("{} ({}): {}", rung.input.name, rung.title, fe.failure));
  return {std::move(fe), prepared.fem.units};
}

/// Whether friction as a vector is computed for the motion of a case, coupled or not.
bool has_vector_friction(const Case& input) {
  return input.motion.moves_tangentially() && input.motion.phase;
}

}  // namespace

std::vector<Rung> rungs_of(const Case& input) {
  std::vector<Rung> rungs;
  if (!input.body.is_half_space()) {
    rungs.push_back({"body", title_of(input.body), input});
    rungs.back().input.elastomer.poisson_ratio = incompressible;
    rungs.back().input.contact = {};
  }
  if (input.elastomer.poisson_ratio != incompressible) {
    rungs.push_back({"poisson_ratio", title_of_ratio(input.elastomer.poisson_ratio), input});
    rungs.back().input.body = {};
    rungs.back().input.contact = {};
  }
  // A motion in two directions asks for friction as a vector, on every rung and of MDR's springs as well.
  if (input.motion.moves_across())
    for (auto& rung : rungs) rung.input.contact.vector_friction = true;
  if (has_vector_friction(input)) {
    rungs.push_back({"friction", "friction as a vector", case_for_mdr(input)});
    rungs.back().input.contact.vector_friction = true;
  }
  return rungs;
}

std::optional<Case> coupled_case(const Case& input) {
  if (!has_vector_friction(input) || (input.body.is_half_space() && input.elastomer.poisson_ratio == incompressible))
    return {};
  auto all = input;
  all.contact = {true, true};
  return all;
}

Case case_for_mdr(const Case& input) {
  auto own = input;
  own.body = {};
  own.elastomer.poisson_ratio = incompressible;
  own.contact = {input.motion.moves_across(), false};
  return own;
}

bool OffBy::is_resolved() const {
  return std::abs(value) > uncertainty;
}

OffBys off_by(const Readings& mdr, const ProvedAnswer& fe, const Units& units) {
  OffBys all;
  const auto scales = scales_of(fe.fe, units);
  for (const auto& [quantity, reading] : readings_of(fe.fe, units)) {
    const auto other = mdr.find(quantity);
    if (!is_on_ladder(quantity) || other == mdr.end()) continue;
    if (!reading.is_compared || !reading.value || !other->second.value) continue;
    if (*reading.value == 0 || *other->second.value == 0) continue;
    OffBy one{reading};
    if (const auto bar = fe.budget.find(quantity); bar != fe.budget.end())
      one.fe.uncertainty = bar->second.total() * scale_of(quantity, scales, *reading.value);
    const double truth = *reading.value, ratio = *other->second.value / truth;
    one.value = ratio - 1;
    one.uncertainty = std::abs(ratio) * one.fe.uncertainty.value_or(0) / std::abs(truth) +
                      other->second.uncertainty.value_or(0) / std::abs(truth);
    all.emplace(quantity, std::move(one));
  }
  return all;
}

std::vector<NotComputed> not_computed_in(const Case& input, double contact_radius) {
  std::vector<NotComputed> list;
  const double mu = input.friction_coefficient, coupling = coupling_of(input, contact_radius);
  if (coupling > 0 && !has_vector_friction(input))
    list.push_back(
        {"normal and tangential contact coupled",
         fmt::format("mu times the coupling of the surface at a wave of the contact radius: {:.2g}", mu * coupling)});
  if (input.elastomer.poisson_ratio > 0 && !has_vector_friction(input))
    list.push_back({"friction as a vector",
                    "some percent of the stick radius at nu = 1/2, in proportion to nu/(2 - nu); none at nu = 0"});
  const double slope = mdr::shape_slope(any_profile_of(input.indenter), contact_radius);
  list.push_back(
      {"finite strains", fmt::format("the slope of the indenter at the edge of the contact: {:.2g}", slope)});
  list.push_back({"adhesion, inertia, heat", "the case does not say what they depend on"});
  return list;
}

Ladder ladder_of(const Case& input, BodyStore& bodies) {
  if (input.wear_kinetics || input.wear == Case::Wear::limiting)
    throw InputError(fmt::format("{}: Wear: a ladder is of an unworn indenter; leave the subsection out", input.file));
  const auto own = mdr_case(case_for_mdr(input));
  if (!own.falls().empty())
    throw InputError(
        fmt::format("{}: Indenter / Table = {}: MDR does not hold for this profile, on any body; `fretval "
                    "run` answers by finite elements",
                    input.file, input.indenter.table));
  Ladder ladder{readings_of(mdr_answer_with_cycle(own, mdr_normal_response(own))), {}, {}, 0, {}, {}};
  std::optional<Proved> all;  // of all assumptions dropped
  const auto off = [&](const Readings& mdr, const Proved& fe) { return off_by(mdr, fe.fe, fe.units); };
  for (const auto& rung : rungs_of(input)) {
    all = proved(rung, bodies);
    ladder.rungs.push_back({rung, off(ladder.mdr, *all)});
  }
  const auto coupled = coupled_case(input);
  Rung without{"whole", coupled ? "all of these" : "the case as it is", input};
  without.input.contact = {has_vector_friction(input), false};
  if (ladder.rungs.size() != 1) all = proved(without, bodies);
  if (coupled) {
    const auto before = all->readings();
    all = proved({"whole", "the case as it is", *coupled}, bodies);
    ladder.rungs.push_back({{"coupling", "pressure and friction coupled", *coupled}, off(before, *all)});
  }
  ladder.whole = {{"whole", "the case as it is", coupled.value_or(without.input)}, off(ladder.mdr, *all)};
  ladder.contact_radius = all->fe.fe.contact_radius_max.value_or(0);
  if (const auto* surface = std::get_if<SurfaceAnswer>(&all->fe.fe.of_kind)) {
    ladder.edges = edges_of(*surface);
    if (own.is_single_pass()) ladder.edges->sticks_in_a_cycle.clear();
  }
  ladder.not_computed = not_computed_in(input, ladder.contact_radius);
  return ladder;
}

}  // namespace fretval
