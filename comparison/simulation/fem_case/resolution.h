#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace fretval {

/// Rings of one width between two radii, all over the contact radius, for an edge that equal rings do not resolve.
struct Focus {
  double inner, outer, ring;
};

/// Where in its ring the contact radius lies, or a focus ends, in rings before the next node. Irrational: no number of
/// rings puts an edge that is known to a node, where it would be read too well. The golden section is the farthest from
/// all fractions.
constexpr double usual_edge_before_node = 0.3819660112501051;

/// How finely a case is discretised.
struct Resolution {
  unsigned elements_per_radius;  ///< rings per contact radius, away from a focus
  unsigned degree;               ///< of the displacement
  double growth;                 ///< element size per distance from the contact
  double far_radius;             ///< over the contact radius
  int steps_per_cycle;
  int n_ramp_cycles;
  double periodicity;            ///< largest relative change from one period to the next
  int n_creep_cycles = 48;       ///< of an unlocked phase, see fem::Motion
  double worn_edge_ring = 5e-6;  ///< limiting profile: rings at its edge over its stick radius
  double surface_growth = 0.15;  ///< of rings that are graded along the surface, per ring
  double wear_jump = 0.01;       ///< worn depth of a jump over the largest indentation, see fem::WearControl
  double edge_before_node = usual_edge_before_node;  ///< that of the contact radius, or of the end of a focus
  double first_step = 0;            ///< how many steps after the motion its first step begins, where it repeats
  std::optional<Focus> focus = {};  ///< empty: equal rings
  unsigned n_angles = 16;           ///< of the full contact, around the axis
  /// Of a given mesh, by how many more refinements its cells are finer than its rings, which neighbours share then;
  /// rings are those of the mesh, or as many of them together as it takes. Empty: meshes are generated.
  std::optional<unsigned> mesh_refinements = {};

  bool operator<(const Resolution& other) const;
  bool operator==(const Resolution& other) const;
};

/// Rings, also those of a focus and of a worn edge, finer by a factor; steps likewise.
Resolution with_rings(Resolution resolution, double factor);
Resolution with_steps(Resolution resolution, double factor);
/// Angles, a multiple of four that has both mirrors.
Resolution with_angles(Resolution resolution, double factor);

/// "24 rings, degree 3, growth 0.5, far 12, 36 steps, 8 ramp cycles", and the focus if there is one.
std::string text_of(const Resolution& resolution);

/// "from 24 rings, ... to 32 rings, ...", with the creep cycles of an unlocked phase where they are what changes.
std::string change_text(const Resolution& before, const Resolution& after);

/// The coarsest settings that usually meet a relative tolerance on the stick radius (and a tenth of it on contact
/// radius and force), as docs/verification.md shows. What they miss in a case, its error budget shows.
/// memory: of the body, see fem::RelaxationModel; without it the start leaves nothing behind and one ramp cycle does.
Resolution resolution_for(double tolerance, bool memory = true);

/// elements_per_radius, degree, growth, far_radius, steps_per_cycle, ramp_cycles, periodicity; focus if there is one.
nlohmann::ordered_json resolution_json(const Resolution& resolution);

/// Inner and outer radius and ring.
nlohmann::ordered_json focus_json(const Focus& focus);

}  // namespace fretval
