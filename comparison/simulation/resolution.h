#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fretval {

/// Rings of one width between two radii, all over the contact radius, for an edge that equal rings do not resolve.
struct Focus {
  double inner, outer, ring;
};

/// How finely a scene is discretised.
struct Resolution {
  unsigned elements_per_radius;  ///< rings per contact radius, away from a focus
  unsigned degree;               ///< of the displacement
  double growth;                 ///< element size per distance from the contact
  double far_radius;             ///< over the contact radius
  int steps_per_cycle;
  int n_ramp_cycles;
  double periodicity;               ///< largest relative change from one period to the next
  int n_creep_cycles = 48;          ///< of an unlocked phase, see fem::Motion
  double worn_edge_ring = 5e-6;     ///< limiting profile: rings at its edge over its stick radius
  double surface_growth = 0.15;     ///< of rings that are graded along the surface, per ring
  double active_set_slack = 1e-13;  ///< see fem::BoxSolver
  std::optional<Focus> focus = {};  ///< empty: equal rings

  bool operator<(const Resolution& other) const;
  bool operator==(const Resolution& other) const;
};

/// "24 rings, degree 3, growth 0.5, far 12, 36 steps, 8 ramp cycles", and the focus if there is one.
std::string text_of(const Resolution& resolution);

/// The coarsest settings that usually meet a relative tolerance on the stick radius (and a tenth of it on contact
/// radius and force), from the measured errors in docs/accuracy.md. What they miss in a case, its error budget shows.
/// memory: of the body, see fem::RelaxationModel; without it the start leaves nothing behind and one ramp cycle does.
Resolution resolution_for(double tolerance, bool memory = true);

/// Where an error comes from.
enum class ErrorSource { rings, element_order, grading, far_field, time_step, start, creep, cycles, active_set, edge };
const char* name_of(ErrorSource source);

/// A resolution that differs from a reference in one respect: coarser, or finer where coarser does not exist.
struct Variant {
  ErrorSource source;
  Resolution resolution, reference;
};

/// What must not be refined or coarsened because the case file fixes it.
struct FixedByCase {
  bool rings, steps;
};

/// What the errors of a scene depend on: an elastic body has no memory of its start, a locked phase does not creep, the
/// rings of a worn profile are graded.
struct SceneNeeds {
  bool memory = true, creep = false, worn = false;
};

/// What has to be computed besides a resolution to measure its errors, each source by its own refinement. The rings are
/// compared with the resolution itself. Where that is fine, the other sources are measured on something coarser that
/// they do not get smaller by: element order and grading with fewer steps, time step, creep and cycles with half the
/// rings, far field, start and active set with both. Two of one source follow each other, the coarser one last.
std::vector<Variant> variants_of(const Resolution& resolution, const SceneNeeds& needs);

/// A resolution that is finer in one respect, rings and steps by a factor of 1.5 or 2; empty: it cannot be refined
/// further in this respect.
std::optional<Resolution> refined(const Resolution& resolution, ErrorSource source, double factor = 2);

/// Steps towards a lower cost, those that usually save most first. Coarser grading makes a body stiffer and a nearer
/// far field makes it softer, so both at once often move less than one of them.
enum class Coarsening {
  half_the_rings,
  half_the_steps,
  three_quarters_of_the_rings,
  three_fifths_of_the_far_radius,
  coarser_outside,  ///< the last and the next at once
  twice_the_growth,
  lower_degree,
  three_quarters_of_the_steps,
  half_the_start,
  half_the_creep,
  ten_times_the_periodicity
};
constexpr int n_coarsenings = 11;

/// A resolution that is coarser in one respect; empty: it cannot be coarsened further in this respect, or the scene
/// does not need what is coarsened.
std::optional<Resolution> coarsened(const Resolution& resolution, Coarsening step, const SceneNeeds& needs);

}  // namespace fretval
