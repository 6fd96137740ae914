#pragma once

#include <array>
#include <string>
#include <vector>

namespace fretval::meshes {

/// The parts of the boundary of the body, with the numbers of their physical groups in a .msh file.
/// axis: r = 0. contact: the part of the surface z = 0 that may touch the indenter. free: the rest of the surface.
/// far: where a half-space is cut off. base: what a body of finite thickness stands on. Of far and base a body has one
/// or both.
enum class Boundary { axis = 1, contact = 2, free = 3, far = 4, base = 5 };

inline constexpr std::array all_boundaries{Boundary::axis, Boundary::contact, Boundary::free, Boundary::far,
                                           Boundary::base};

/// The boundaries that every body has.
inline constexpr std::array needed_boundaries{Boundary::axis, Boundary::contact, Boundary::free};

/// Number and name of the physical group of all cells in a .msh file.
inline constexpr int body_group = 10;
inline constexpr const char* body_name = "body";

/// Quadrilateral mesh of the meridian half-plane (r, z) of an axisymmetric body in r >= 0, z <= 0.
/// Lengths are in metres, or in whatever unit the maker of the mesh chose; nothing here depends on it.
struct Mesh {
  struct Edge {
    std::array<unsigned, 2> nodes;
    Boundary boundary;
  };

  std::vector<std::array<double, 2>> nodes;    ///< (r, z)
  std::vector<std::array<unsigned, 4>> cells;  ///< indices into nodes, counter-clockwise
  std::vector<Edge> edges;                     ///< the boundary, each edge once
  std::vector<std::string> materials = {};     ///< names; empty: all of the body is of one
  std::vector<unsigned> material = {};         ///< of each cell, an index into materials, as many as cells; or empty
};

/// Name of the physical group of a part of the boundary: "axis", "contact", "free", "far" or "base".
std::string boundary_name(Boundary boundary);

/// Sum of the lengths of the edges of one part of the boundary, in the unit of the nodes.
double boundary_length(const Mesh& mesh, Boundary boundary);

/// Radii of the nodes of the contact line, in increasing order.
std::vector<double> contact_radii(const Mesh& mesh);

}  // namespace fretval::meshes
