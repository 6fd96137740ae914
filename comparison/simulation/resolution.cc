#include "comparison/simulation/resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace fretval {
namespace {

constexpr unsigned most_rings = 512, fewest_rings = 8, most_degree = 4;
constexpr unsigned fewest_rings_of_a_variant = 6;  // 24 rings have two to be compared with
constexpr int most_steps = 1440, fewest_steps = 8, most_ramp_cycles = 64, most_creep_cycles = 768;
constexpr double finest_growth = 0.075, coarsest_growth = 1, finest_periodicity = 1e-9, coarsest_periodicity = 1e-3;
constexpr double largest_far_radius = 100, smallest_far_radius = 4;
constexpr unsigned least_degree = 2;
constexpr int fewest_creep_cycles = 6;
constexpr double finest_edge_ring = 2e-6;  // gmsh tells nodes apart down to some 1e-7 of the contact line

Resolution with_rings(Resolution r, double factor) {
  r.elements_per_radius = static_cast<unsigned>(r.elements_per_radius * factor);
  r.worn_edge_ring = std::max(r.worn_edge_ring / (factor * factor), finest_edge_ring);
  r.surface_growth /= factor;
  if (r.focus) r.focus->ring /= factor;
  return r;
}

Resolution with_steps(Resolution r, double factor) {
  r.steps_per_cycle = static_cast<int>(r.steps_per_cycle * factor);
  return r;
}

/// The coarsest resolutions on which an error of another source is measured.
constexpr unsigned enough_rings = 24;
constexpr int enough_steps = 24;

Resolution with_fewer_rings(const Resolution& r) {
  return r.elements_per_radius / 2 >= enough_rings ? with_rings(r, 0.5) : r;
}

Resolution with_fewer_steps(const Resolution& r) {
  for (const int divisor : {4, 2})
    if (r.steps_per_cycle / divisor >= enough_steps) return with_steps(r, 1.0 / divisor);
  return r;
}

auto key(const Resolution& r) {
  return std::make_tuple(r.elements_per_radius, r.degree, r.growth, r.far_radius, r.steps_per_cycle, r.n_ramp_cycles,
                         r.periodicity, r.n_creep_cycles, r.worn_edge_ring, r.surface_growth, r.active_set_slack,
                         r.focus.has_value(), r.focus ? r.focus->inner : 0, r.focus ? r.focus->outer : 0,
                         r.focus ? r.focus->ring : 0);
}

}  // namespace

bool Resolution::operator<(const Resolution& other) const {
  return key(*this) < key(other);
}

bool Resolution::operator==(const Resolution& other) const {
  return key(*this) == key(other);
}

std::string text_of(const Resolution& r) {
  auto text = fmt::format("{} rings, degree {}, growth {:g}, far {:g}, {} steps, {} ramp cycles", r.elements_per_radius,
                          r.degree, r.growth, r.far_radius, r.steps_per_cycle, r.n_ramp_cycles);
  if (r.focus)
    text += fmt::format(", rings of {:.2g} from {:.6g} to {:.6g}", r.focus->ring, r.focus->inner, r.focus->outer);
  return text;
}

Resolution resolution_for(double tolerance, bool memory) {
  // What the rings at a worn edge let through is about a tenth of sqrt(2 ring/c) of the force.
  const double worn_edge_ring = std::max(5 * tolerance * tolerance, finest_edge_ring);
  const auto ramp = [memory](int n_cycles) { return memory ? n_cycles : 1; };
  if (tolerance >= 1e-2) return {24, 2, 0.3, 10, 32, ramp(4), 1e-4, 24, worn_edge_ring};
  if (tolerance >= 1e-3) return {24, 3, 0.5, 12, 36, ramp(8), 1e-5, 48, worn_edge_ring};
  return {48, 3, 0.3, 20, 72, ramp(12), 1e-6, 96, worn_edge_ring};
}

const char* name_of(ErrorSource source) {
  switch (source) {
    case ErrorSource::rings:
      return "rings";
    case ErrorSource::element_order:
      return "element order";
    case ErrorSource::grading:
      return "grading";
    case ErrorSource::far_field:
      return "far field";
    case ErrorSource::time_step:
      return "time step";
    case ErrorSource::start:
      return "start";
    case ErrorSource::creep:
      return "creep";
    case ErrorSource::cycles:
      return "cycles";
    case ErrorSource::active_set:
      return "active set";
    case ErrorSource::edge:
      break;
  }
  return "edge";
}

std::vector<Variant> variants_of(const Resolution& resolution, const SceneNeeds& needs) {
  std::vector<Variant> variants;
  const auto add = [&](ErrorSource source, const Resolution& reference, auto change) {
    Resolution r = reference;
    change(r);
    variants.push_back({source, r, reference});
  };
  for (const double factor : {0.5, 0.25})
    if (resolution.elements_per_radius * factor >= fewest_rings_of_a_variant)
      variants.push_back({ErrorSource::rings, with_rings(resolution, factor), resolution});
  const Resolution quick = with_fewer_steps(resolution), coarse = with_fewer_rings(resolution),
                   both = with_fewer_steps(coarse);
  add(ErrorSource::element_order, quick, [](Resolution& r) { r.degree = r.degree > 2 ? r.degree - 1 : r.degree + 1; });
  add(ErrorSource::grading, quick, [](Resolution& r) { r.growth = std::min(2 * r.growth, coarsest_growth); });
  add(ErrorSource::far_field, both, [](Resolution& r) { r.far_radius /= 2; });
  for (const double factor : {0.5, 0.25})
    if (coarse.steps_per_cycle * factor >= fewest_steps)
      variants.push_back({ErrorSource::time_step, with_steps(coarse, factor), coarse});
  if (needs.memory) add(ErrorSource::start, both, [](Resolution& r) { r.n_ramp_cycles /= 2; });
  if (needs.creep)
    for (const int divisor : {2, 4})
      add(ErrorSource::creep, coarse, [&](Resolution& r) { r.n_creep_cycles /= divisor; });
  add(ErrorSource::cycles, coarse, [](Resolution& r) { r.periodicity *= 10; });
  add(ErrorSource::active_set, both, [](Resolution& r) { r.active_set_slack *= 10; });
  return variants;
}

std::optional<Resolution> refined(const Resolution& resolution, ErrorSource source, double factor) {
  Resolution r = resolution;
  switch (source) {
    case ErrorSource::rings:
    case ErrorSource::edge:
      if (factor * r.elements_per_radius > most_rings) return std::nullopt;
      return with_rings(r, factor);
    case ErrorSource::element_order:
      if (++r.degree > most_degree) return std::nullopt;
      return r;
    case ErrorSource::grading:
      if ((r.growth /= 2) < finest_growth) return std::nullopt;
      return r;
    case ErrorSource::far_field:
      if ((r.far_radius *= 2) > largest_far_radius) return std::nullopt;
      return r;
    case ErrorSource::time_step:
      if (factor * r.steps_per_cycle > most_steps) return std::nullopt;
      return with_steps(r, factor);
    case ErrorSource::start:
      if ((r.n_ramp_cycles *= 2) > most_ramp_cycles) return std::nullopt;
      return r;
    case ErrorSource::creep:
      if ((r.n_creep_cycles *= 2) > most_creep_cycles) return std::nullopt;
      return r;
    case ErrorSource::cycles:
      if ((r.periodicity /= 10) < finest_periodicity) return std::nullopt;
      return r;
    case ErrorSource::active_set:
      break;
  }
  return std::nullopt;
}

std::optional<Resolution> coarsened(const Resolution& resolution, Coarsening step, const SceneNeeds& needs) {
  constexpr double nearer = 0.6;
  Resolution r = resolution;
  const auto if_coarse_enough = [&](bool allowed) { return allowed ? std::optional(r) : std::nullopt; };
  switch (step) {
    case Coarsening::half_the_rings:
    case Coarsening::three_quarters_of_the_rings:
      r = with_rings(
          r, std::max(step == Coarsening::half_the_rings ? 0.5 : 0.75, (fewest_rings + 1e-9) / r.elements_per_radius));
      return if_coarse_enough(r.elements_per_radius < resolution.elements_per_radius);
    case Coarsening::lower_degree:
      --r.degree;
      return if_coarse_enough(r.degree >= least_degree);
    case Coarsening::half_the_steps:
    case Coarsening::three_quarters_of_the_steps:
      r = with_steps(r, step == Coarsening::half_the_steps ? 0.5 : 0.75);
      return if_coarse_enough(r.steps_per_cycle >= fewest_steps);
    case Coarsening::three_fifths_of_the_far_radius:
      r.far_radius = std::max(nearer * r.far_radius, smallest_far_radius);
      return if_coarse_enough(r.far_radius < resolution.far_radius);
    case Coarsening::coarser_outside: {
      const auto first = coarsened(resolution, Coarsening::three_fifths_of_the_far_radius, needs);
      return first ? coarsened(*first, Coarsening::twice_the_growth, needs) : std::nullopt;
    }
    case Coarsening::twice_the_growth:
      r.growth = std::min(2 * r.growth, coarsest_growth);
      return if_coarse_enough(r.growth > resolution.growth);
    case Coarsening::half_the_start:
      r.n_ramp_cycles /= 2;
      return if_coarse_enough(needs.memory && r.n_ramp_cycles > 0);
    case Coarsening::half_the_creep:
      r.n_creep_cycles /= 2;
      return if_coarse_enough(needs.creep && r.n_creep_cycles >= fewest_creep_cycles);
    case Coarsening::ten_times_the_periodicity:
      break;
  }
  r.periodicity *= 10;
  return if_coarse_enough(r.periodicity <= coarsest_periodicity);
}

}  // namespace fretval
