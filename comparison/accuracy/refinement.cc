#include "comparison/accuracy/refinement.h"

#include <algorithm>
#include <array>

namespace fretval {
namespace {

constexpr unsigned most_rings = 512, most_angles = 64, fewest_angles = 8, most_degree = 4;
constexpr unsigned fewest_rings_of_a_variant = 6;  // 24 rings have two to be compared with
constexpr int most_steps = 1440, fewest_steps = 8, most_ramp_cycles = 64, most_creep_cycles = 768;
constexpr double finest_growth = 0.075, coarsest_growth = 1, finest_periodicity = 1e-9, finest_wear_jump = 1e-3,
                 largest_far_radius = 100;

/// Least numbers of rings per radius and of steps in a cycle with which an error of another source is measured.
constexpr unsigned enough_rings = 24;
constexpr int enough_steps = 24;
/// Cycles in which a motion without a period goes through its phases where an error of another source is measured.
constexpr int enough_creep_cycles = 12;

/// Shifts in rings: the contact radius as far as possible from its place in a ring, then an edge at half of that
/// radius.
constexpr std::array elsewhere_in_ring{0.5, 1.0};

Resolution with_fewer_rings(const Resolution& r) {
  return r.elements_per_radius / 2 >= enough_rings ? with_rings(r, 0.5) : r;
}

Resolution with_fewer_steps(const Resolution& r) {
  for (const int divisor : {4, 2})
    if (r.steps_per_cycle / divisor >= enough_steps) return with_steps(r, 1.0 / divisor);
  return r;
}

Resolution with_fewer_creep_cycles(Resolution r, const CaseNeeds& needs) {
  if (needs.without_period) r.n_creep_cycles = std::min(r.n_creep_cycles, enough_creep_cycles);
  return r;
}

/// Half of the steps, for the variants in rings and edges: with a quarter of them, bars of 1e-5 would be twice as wide.
Resolution with_half_the_steps(const Resolution& r, const CaseNeeds& needs) {
  if (needs.moves_by_steps || needs.kind == ContactKind::annuli || r.steps_per_cycle / 2 < enough_steps) return r;
  return with_steps(r, 0.5);
}

template <class Change>
Variant variant(ErrorSource source, const Resolution& reference, Change change) {
  Resolution r = reference;
  change(r);
  return {source, r, reference};
}

/// Whether a given mesh has so few rings that coarser ones would show nothing, and finer ones are compared with
/// instead.
bool has_few_given_rings(const Resolution& r) {
  return r.mesh_refinements && r.elements_per_radius < 4 * fewest_rings_of_a_variant;
}

/// A given mesh cannot be meshed in another way: its cells are split, under the same rings for the grading, and under
/// rings that begin elsewhere for the edge.
void add_of_given_mesh(const Resolution& for_rings, const Resolution& quick, std::vector<Variant>& variants) {
  const auto finer = [](Resolution r) {
    ++*r.mesh_refinements;
    return r;
  };
  variants.push_back(variant(ErrorSource::edge, finer(for_rings),
                             [](Resolution& r) { r.edge_before_node += elsewhere_in_ring.front(); }));
  variants.push_back({ErrorSource::grading, finer(quick), quick});
}

void other_degree(Resolution& r) {
  r.degree = r.degree > 2 ? r.degree - 1 : r.degree + 1;
}

}  // namespace

const char* name_of(ErrorSource source) {
  // In the order of the enumeration.
  static constexpr std::array names{"rings", "angles", "element order", "grading", "far field", "time step", "start",
                                    "creep", "cycles", "wear jump",     "edge",    "instants",  "data"};
  return names[static_cast<std::size_t>(source)];
}

std::vector<Variant> variants_of(const Resolution& all_angles, const CaseNeeds& needs) {
  std::vector<Variant> variants;
  const bool is_full = needs.kind == ContactKind::plane;
  const Resolution all_cycles =
                       is_full && all_angles.n_angles > fewest_angles ? with_angles(all_angles, 0.5) : all_angles,
                   resolution = with_fewer_creep_cycles(all_cycles, needs);
  const auto add = [&](ErrorSource source, const Resolution& reference, auto change) {
    variants.push_back(variant(source, reference, change));
  };
  const Resolution quick = with_fewer_steps(resolution), coarse = with_fewer_rings(resolution),
                   both = with_fewer_steps(coarse), for_rings = with_half_the_steps(resolution, needs);
  if (has_few_given_rings(resolution))
    variants.push_back({ErrorSource::rings, with_rings(for_rings, 2), for_rings});
  else
    for (const double factor : {0.5, 0.25})
      if (resolution.elements_per_radius * factor >= fewest_rings_of_a_variant)
        variants.push_back({ErrorSource::rings, with_rings(for_rings, factor), for_rings});
  if (is_full) {
    const auto quick_rings = with_fewer_steps(with_fewer_rings(all_angles));
    variants.push_back({ErrorSource::angles, with_angles(quick_rings, 0.5), quick_rings});
  }
  if (resolution.mesh_refinements)
    add_of_given_mesh(for_rings, quick, variants);
  else if (needs.kind == ContactKind::discs || is_full)
    for (const double rings : elsewhere_in_ring)
      add(ErrorSource::edge, for_rings, [rings](Resolution& r) { r.edge_before_node += rings; });
  add(ErrorSource::element_order, quick, other_degree);
  if (!resolution.mesh_refinements) {
    add(ErrorSource::grading, quick, [](Resolution& r) { r.growth = std::min(2 * r.growth, coarsest_growth); });
    add(ErrorSource::far_field, both, [](Resolution& r) { r.far_radius /= 2; });
  }
  for (const double factor : {0.5, 0.25})
    if (coarse.steps_per_cycle * factor >= fewest_steps)
      variants.push_back({ErrorSource::time_step, with_steps(coarse, factor), coarse});
  if (needs.begins_anywhere) add(ErrorSource::instants, coarse, [](Resolution& r) { r.first_step += 0.5; });
  if (needs.memory && !is_pass(needs.motion_kind))
    add(ErrorSource::start, both, [](Resolution& r) { r.n_ramp_cycles /= 2; });
  if (needs.creep)
    for (const int divisor : {2, 4})
      add(ErrorSource::creep, with_fewer_rings(all_cycles), [&](Resolution& r) { r.n_creep_cycles /= divisor; });
  if (!is_pass(needs.motion_kind)) add(ErrorSource::cycles, both, [](Resolution& r) { r.periodicity *= 10; });
  return variants;
}

/// The element order is compared with a degree of the same parity: next to a singular edge, elements of even and of odd
/// degree err to opposite sides, see resolution_for_wear.
std::vector<Variant> variants_of_wear(const Resolution& resolution) {
  const Resolution coarse = with_rings(resolution, 0.5), quick = with_steps(coarse, 0.5);
  return {{ErrorSource::rings, coarse, resolution},
          {ErrorSource::rings, with_rings(resolution, 0.25), resolution},
          variant(ErrorSource::element_order, quick, [](Resolution& r) { r.degree -= 2; }),
          variant(ErrorSource::far_field, quick, [](Resolution& r) { r.far_radius /= 2; }),
          {ErrorSource::time_step, quick, coarse},
          {ErrorSource::time_step, with_steps(coarse, 0.25), coarse},
          variant(ErrorSource::wear_jump, quick, [](Resolution& r) { r.wear_jump *= 2; }),
          variant(ErrorSource::wear_jump, quick, [](Resolution& r) { r.wear_jump *= 4; })};
}

std::optional<Resolution> refined(const Resolution& resolution, ErrorSource source, double factor) {
  Resolution r = resolution;
  const auto within = [](bool limits, const Resolution& finer) { return limits ? std::optional(finer) : std::nullopt; };
  switch (source) {
    case ErrorSource::rings:
    case ErrorSource::edge:
      return within(factor * r.elements_per_radius <= most_rings, with_rings(r, factor));
    case ErrorSource::angles:
      return within(factor * r.n_angles <= most_angles, with_angles(r, factor));
    case ErrorSource::element_order:
      return within(++r.degree <= most_degree, r);
    case ErrorSource::grading:
      return within(!r.mesh_refinements && (r.growth /= 2) >= finest_growth, r);
    case ErrorSource::far_field:
      return within((r.far_radius *= 2) <= largest_far_radius, r);
    case ErrorSource::time_step:
    case ErrorSource::instants:
      return within(factor * r.steps_per_cycle <= most_steps, with_steps(r, factor));
    case ErrorSource::start:
      return within((r.n_ramp_cycles *= 2) <= most_ramp_cycles, r);
    case ErrorSource::creep:
      return within((r.n_creep_cycles *= 2) <= most_creep_cycles, r);
    case ErrorSource::cycles:
      return within((r.periodicity /= 10) >= finest_periodicity, r);
    case ErrorSource::wear_jump:
      return within((r.wear_jump /= 2) >= finest_wear_jump, r);
    case ErrorSource::data:
      break;
  }
  return std::nullopt;
}

}  // namespace fretval
