#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fretval::meshes {

/// What a .msh file says, before it is checked to be a mesh of ours.
struct MshSections {
  struct Element {
    long long number;             ///< its number in the file
    int type;                     ///< gmsh's: point, line, triangle or quadrilateral, see below
    long long group;              ///< number of its physical group, 0: none
    std::vector<unsigned> nodes;  ///< indices into nodes
    long long entity = 0;         ///< number of the geometrical entity that it is a part of, 0: none
  };

  std::map<std::pair<int, long long>, std::string> group_names;  ///< by dimension and number
  std::vector<long long> node_numbers;                           ///< in the file
  std::vector<std::array<double, 3>> nodes;
  std::vector<Element> elements;
};

/// gmsh's numbers of the element types that are understood.
inline constexpr int msh_line = 1;
inline constexpr int msh_triangle = 2;
inline constexpr int msh_quadrilateral = 3;
inline constexpr int msh_point = 15;

/// Reads the sections MeshFormat, PhysicalNames, Entities, Nodes and Elements of an ASCII file of version 2.2 or 4.1,
/// and passes over all others. Throws MeshError with file and line for anything malformed, and for other element types.
MshSections read_sections(const std::filesystem::path& file);

/// Name of the physical group of an element; empty if it is in none, or in one without a name.
std::string group_name(const MshSections& sections, const MshSections::Element& element);

}  // namespace fretval::meshes
