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

  [[nodiscard]] bool is_half_space() const { return thickness == 0; }
  [[nodiscard]] bool has_merged_rings() const { return !given.radii.empty(); }

  /// All fields, in the one order in which they are compared, kept and sent.
  template <class Body>
  static auto fields(Body& body) {
    return std::tie(body.contact_nodes, body.growth, body.far_radius, body.degree, body.tangential, body.scale,
                    body.poisson_ratio, body.thickness, body.slides_on_base, body.given.file, body.given.content,
                    body.given.moduli, body.given.n_refinements, body.given.radii);
  }
  bool operator<(const BodyDescription& other) const { return fields(*this) < fields(other); }
};

/// A half-space that knows where the edge of a disc of these rings lies (fem::Compliance::half_space): with the same
/// rings or, of equal ones, with the innermost 40, over their width. So all bodies of equal rings that have Poisson's
/// ratio, degree and growth in common share one, whatever their thickness and the number of their rings.
BodyDescription half_space_with_rings_of(const BodyDescription& body);

}  // namespace fretval
