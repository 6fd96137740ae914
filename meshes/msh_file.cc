#include "meshes/msh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <system_error>

#include "meshes/msh_sections.h"
#include "meshes/quality.h"

namespace fretval::meshes {
namespace {

std::string as_text(const Mesh& mesh) {
  std::set<Boundary> boundaries;
  for (const auto& edge : mesh.edges) boundaries.insert(edge.boundary);
  std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n",
                                 boundaries.size() + std::max<std::size_t>(mesh.materials.size(), 1));
  for (const Boundary boundary : boundaries)
    text += fmt::format("1 {} \"{}\"\n", static_cast<int>(boundary), boundary_name(boundary));
  const auto materials = mesh.materials.empty() ? std::vector<std::string>{body_name} : mesh.materials;
  for (std::size_t i = 0; i < materials.size(); ++i)
    text += fmt::format("2 {} \"{}\"\n", body_group + i, materials[i].empty() ? body_name : materials[i]);
  text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("{} {} {} 0\n", i + 1, mesh.nodes[i][0], mesh.nodes[i][1]);
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.edges.size() + mesh.cells.size());
  std::size_t number = 0;
  for (const auto& [nodes, boundary] : mesh.edges) {
    const auto group = static_cast<int>(boundary);
    text += fmt::format("{} {} 2 {} {} {} {}\n", ++number, msh_line, group, group, nodes[0] + 1, nodes[1] + 1);
  }
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    const unsigned group = body_group + (mesh.material.empty() ? 0 : mesh.material[i]);
    text += fmt::format("{} {} 2 {} {} {} {} {} {}\n", ++number, msh_quadrilateral, group, group, cell[0] + 1,
                        cell[1] + 1, cell[2] + 1, cell[3] + 1);
  }
  return text + "$EndElements\n";
}

std::vector<std::array<double, 2>> plane_nodes(const MshSections& sections, const std::string& file) {
  std::vector<std::array<double, 2>> nodes;
  for (std::size_t i = 0; i < sections.nodes.size(); ++i) {
    const auto& [r, z, out_of_plane] = sections.nodes[i];
    if (out_of_plane != 0.)
      throw MeshError(fmt::format("{}: node {} at ({}, {}, {}) has third coordinate {}, must be 0", file,
                                  sections.node_numbers[i], r, z, out_of_plane, out_of_plane));
    nodes.push_back({r, z});
  }
  return nodes;
}

[[noreturn]] void fail_group(const std::string& file, const MshSections::Element& element, const std::string& name,
                             const char* valid) {
  throw MeshError(fmt::format("{}: {} element {} is in physical group {} \"{}\", must be in {}", file,
                              element.type == msh_line ? "line" : "quadrilateral", element.number, element.group, name,
                              valid));
}

Boundary boundary_named(const std::string& file, const MshSections::Element& element, const std::string& name) {
  for (const Boundary boundary : all_boundaries)
    if (boundary_name(boundary) == name) return boundary;
  fail_group(file, element, name, "\"axis\", \"contact\", \"free\", \"far\" or \"base\"");
}

void check_groups(const std::set<std::string>& found, const std::string& file) {
  std::vector<std::string> wanted{body_name};
  for (const Boundary boundary : needed_boundaries) wanted.push_back(boundary_name(boundary));
  // Either of the two holds the body.
  wanted.push_back(boundary_name(found.count(boundary_name(Boundary::base)) > 0 ? Boundary::base : Boundary::far));
  for (const auto& name : wanted)
    if (found.count(name) == 0)
      throw MeshError(fmt::format("{}: physical group \"{}\" has no elements, found {}, must have all of {}", file,
                                  name, found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", ")),
                                  fmt::join(wanted, ", ")));
}

/// A surface drawn the other way round makes all cells clockwise; single ones are a defect, left for `audit`.
void turn_if_all_clockwise(Mesh& mesh) {
  const bool all = std::all_of(mesh.cells.begin(), mesh.cells.end(),
                               [&mesh](const auto& cell) { return signed_area(mesh, cell) < 0.; });
  if (!all) return;
  for (auto& cell : mesh.cells) std::reverse(cell.begin(), cell.end());
}

}  // namespace

void write_msh(const Mesh& mesh, const std::filesystem::path& file) {
  const std::filesystem::path partial = file.string() + ".partial";
  const std::string text = as_text(mesh);
  errno = 0;
  std::ofstream stream(partial, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    const std::error_code reason(errno == 0 ? EIO : errno, std::generic_category());
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw std::filesystem::filesystem_error("mesh not written", partial, reason);
  }
  std::filesystem::rename(partial, file);
}

Mesh read_msh(const std::filesystem::path& path) {
  const std::string file = path.string();
  const MshSections sections = read_sections(path);
  Mesh mesh{plane_nodes(sections, file), {}, {}};
  std::set<std::string> found;
  for (const auto& element : sections.elements) {
    if (element.type == msh_point) continue;
    const std::string name = group_name(sections, element);
    const auto& nodes = element.nodes;
    if (element.type == msh_line) {
      mesh.edges.push_back({{nodes[0], nodes[1]}, boundary_named(file, element, name)});
    } else {
      if (element.type == msh_triangle)
        throw MeshError(fmt::format("{}: element {} is of type 2 (triangle), must be 3 (4-node quadrilateral)", file,
                                    element.number));
      if (name != body_name) fail_group(file, element, name, "\"body\"");
      mesh.cells.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
    }
    found.insert(name);
  }
  check_groups(found, file);
  turn_if_all_clockwise(mesh);
  return mesh;
}

}  // namespace fretval::meshes
