#pragma once

#include <string>
#include <tuple>
#include <vector>

namespace fretval {

/// A mesh that the case brings along (meshes::read_user_mesh).
struct GivenMesh {
  std::string file;                 ///< empty: there is none, the mesh is generated
  std::string content = {};         ///< what tells it from others, see content_hash
  std::vector<double> moduli = {};  ///< of its materials, over that of the body
  unsigned n_refinements = 0;       ///< how often all of its cells are split into four
  std::vector<double> radii = {};   ///< of its nodes on the contact line, where rings are wider than its edges
};

/// Rings of another width on a body that is known under its own rings (fem::moved_rings).
struct MovedRings {
  double factor = 1;                      ///< of the width; 1: they are those of the body
  std::vector<double> coarse_nodes = {};  ///< of the rings by which its smooth part is found
  double coarse_far_radius = 0;           ///< of the body with these
};

/// What determines the mesh and the operators; equal descriptions share them. Lengths are over the unit of the case.
struct BodyDescription {
  std::vector<double> contact_nodes;  ///< ring radii
  double growth;                      ///< element size per distance from the contact
  double far_radius;                  ///< where a half-space is cut off; otherwise of the side
  unsigned degree;
  bool tangential = true;  ///< whether the tangential order is needed
  double scale = 1;        ///< of a half-space or a given mesh, by which all of it is larger
  double poisson_ratio = 0.5;
  double thickness = 0;         ///< down to a flat base; 0: a half-space
  bool slides_on_base = false;  ///< without friction; otherwise it is bonded
  GivenMesh given = {};         ///< over the length of its contact line
  MovedRings moved = {};        ///< of a body of finite thickness

  [[nodiscard]] bool is_half_space() const { return thickness == 0; }
  [[nodiscard]] bool has_merged_rings() const { return !given.radii.empty(); }
  [[nodiscard]] bool has_moved_rings() const { return moved.factor != 1; }

  /// All fields, in the one order in which they are compared, kept and sent.
  template <class Body>
  static auto fields(Body& body) {
    return std::tie(body.contact_nodes, body.growth, body.far_radius, body.degree, body.tangential, body.scale,
                    body.poisson_ratio, body.thickness, body.slides_on_base, body.given.file, body.given.content,
                    body.given.moduli, body.given.n_refinements, body.given.radii, body.moved.factor,
                    body.moved.coarse_nodes, body.moved.coarse_far_radius);
  }
  bool operator<(const BodyDescription& other) const { return fields(*this) < fields(other); }
};

/// Number of rings of the half-space of a body with equal rings.
constexpr std::size_t equal_rings_of_half_space = 24;

/// A half-space that knows where the edge of a disc of these rings lies (fem::Compliance::half_space): with the same
/// rings or, of equal ones, with the innermost 24, over their width. So all bodies of equal rings that have Poisson's
/// ratio, degree and growth in common share one, whatever their thickness and the number of their rings.
BodyDescription half_space_with_rings_of(const BodyDescription& body);

}  // namespace fretval
