#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparison/case_file/case_sections.h"
#include "comparison/case_file/units.h"
#include "comparison/support/content_hash.h"
#include "comparison/support/files.h"
#include "comparison/support/text.h"
#include "mdr/support/trimmed.h"
#include "meshes/user_mesh.h"

namespace fretval {
namespace {

const char* const body_section = "Body";

/// The unit of a mesh in m, from "mm", "25.4 mm" or a number in m; 1 m where it is not set.
double mesh_unit(const EntryReader& entries) {
  auto text = entries.text(body_section, "Mesh unit");
  if (text.empty()) return 1;
  if (text.find_first_of("0123456789") == std::string::npos) text = "1 " + text;
  const auto unit = read_measure(text, Dimension::length);
  if (unit && unit->value > 0) return unit->value;
  entries.fail(body_section, "Mesh unit",
               "a unit of length as mm, or a positive length, " + valid_units(Dimension::length));
  return 1;
}

/// "pad 1": the last word is the number, and what comes before it the name, which may have blanks.
std::optional<Case::Body::RelativeModulus> modulus_in(const std::string& text) {
  const auto blank = text.find_last_of(" \t=:");
  if (blank == std::string::npos) return std::nullopt;
  auto name = trimmed(text.substr(0, text.find_last_not_of(" \t=:", blank) + 1));
  const auto value = read_measure(text.substr(blank + 1), Dimension::number);
  if (name.empty() || !value || !(value->value > 0)) return std::nullopt;
  return Case::Body::RelativeModulus{std::move(name), value->value};
}

void read_relative_moduli(const EntryReader& entries, Case::Body& body) {
  const char* const name = "Relative moduli";
  std::string rest = entries.text(body_section, name);
  while (!rest.empty()) {
    const auto end = rest.find(',');
    const auto modulus = modulus_in(trimmed(rest.substr(0, end)));
    if (!modulus) {
      entries.fail(body_section, name,
                   "names of physical surfaces, each with a positive number, separated by commas, as pad 1, skin 8");
      return;
    }
    const bool is_twice = std::any_of(body.relative_moduli.begin(), body.relative_moduli.end(),
                                      [&](const auto& other) { return other.material == modulus->material; });
    if (is_twice) entries.fail(body_section, name, fmt::format("each name once; {} is there twice", modulus->material));
    body.relative_moduli.push_back(*modulus);
    rest = end == std::string::npos ? "" : rest.substr(end + 1);
  }
}

void require_known_materials(const EntryReader& entries, const Case::Body& body) {
  auto names = body.grid->materials;
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  for (const auto& [material, value] : body.relative_moduli)
    if (std::find(names.begin(), names.end(), material) == names.end())
      entries.fail(body_section, "Relative moduli",
                   names.empty()
                       ? fmt::format("nothing: {} has no physical surfaces, and so no {}", body.mesh, material)
                       : fmt::format("physical surfaces of {}, which are {}; there is no {}{}", body.mesh,
                                     fmt::join(names, ", "), material, did_you_mean(material, names)));
}

}  // namespace

void read_mesh_entries(const EntryReader& entries, Case::Body& body) {
  body.mesh = entries.path(body_section, "Mesh");
  body.mesh_unit = mesh_unit(entries);
  read_relative_moduli(entries, body);
  if (body.mesh.empty()) return;
  try {
    auto grid = meshes::read_user_mesh(body.mesh);
    for (const auto& [nodes, boundary] : grid.edges)
      if (boundary == meshes::Boundary::axis)
        for (const unsigned node : nodes)
          body.thickness = std::max(body.thickness, -grid.nodes[node][1] * body.mesh_unit);
    body.mesh_hash = content_hash(content_of(body.mesh));
    body.grid = std::make_shared<const meshes::Mesh>(std::move(grid));
    require_known_materials(entries, body);
  } catch (const meshes::MeshError& error) {
    entries.fail(body_section, "Mesh", fmt::format("a mesh of a body that can be computed: {}", error.what()));
  }
}

bool has_level_base(const meshes::Mesh& mesh) {
  double low = 0, high = -HUGE_VAL;
  for (const auto& [nodes, boundary] : mesh.edges)
    if (boundary == meshes::Boundary::base)
      for (const unsigned node : nodes) {
        low = std::min(low, mesh.nodes[node][1]);
        high = std::max(high, mesh.nodes[node][1]);
      }
  constexpr double roundoff = 1e-9;
  return high - low <= roundoff * std::abs(low);
}

std::vector<double> moduli_of_materials(const Case::Body& body) {
  std::vector<double> moduli;
  for (const auto& name : body.grid->materials) {
    const auto found = std::find_if(body.relative_moduli.begin(), body.relative_moduli.end(),
                                    [&](const auto& one) { return one.material == name; });
    moduli.push_back(found == body.relative_moduli.end() ? 1 : found->value);
  }
  return moduli;
}

}  // namespace fretval
