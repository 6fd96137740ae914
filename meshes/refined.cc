#include "meshes/refined.h"

#include "meshes/split.h"

namespace fretval::meshes {

Mesh split(const MixedMesh& mixed) {
  CoarseMesh coarse{mixed.nodes, mixed.polygons, {}};
  for (const auto& edge : mixed.edges) coarse.edges.push_back({edge.nodes, Side::surface});
  auto fine = split(coarse);
  Mesh mesh{std::move(fine.nodes), std::move(fine.cells), {}, mixed.materials, {}};
  // In the split mesh the two halves of an edge stand next to each other, and so do the parts of a polygon.
  for (std::size_t i = 0; i < fine.edges.size(); ++i)
    mesh.edges.push_back({fine.edges[i].nodes, mixed.edges[i / 2].boundary});
  if (!mixed.material.empty())
    for (std::size_t p = 0; p < mixed.polygons.size(); ++p)
      mesh.material.insert(mesh.material.end(), mixed.polygons[p].size(), mixed.material[p]);
  return mesh;
}

Mesh refined(const Mesh& mesh) {
  MixedMesh mixed{mesh.nodes, {}, mesh.edges, mesh.materials, mesh.material};
  for (const auto& cell : mesh.cells) mixed.polygons.emplace_back(cell.begin(), cell.end());
  return split(mixed);
}

}  // namespace fretval::meshes
