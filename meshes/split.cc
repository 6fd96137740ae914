#include "meshes/split.h"

#include <algorithm>
#include <map>
#include <utility>

namespace fretval::meshes {
namespace {

/// Adds the node in the middle of every edge, and knows it from the two ends of the edge.
class EdgeMiddles {
 public:
  explicit EdgeMiddles(std::vector<std::array<double, 2>>& nodes) : nodes(nodes) {}

  unsigned operator()(unsigned a, unsigned b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<unsigned>(nodes.size()));
    if (is_new) nodes.push_back({(nodes[a][0] + nodes[b][0]) / 2., (nodes[a][1] + nodes[b][1]) / 2.});
    return found->second;
  }

 private:
  std::vector<std::array<double, 2>>& nodes;
  std::map<std::pair<unsigned, unsigned>, unsigned> middles;
};

std::array<double, 2> mean(const std::vector<std::array<double, 2>>& nodes, const std::vector<unsigned>& polygon) {
  std::array<double, 2> sum{0., 0.};
  for (const unsigned node : polygon)
    for (const int i : {0, 1}) sum[i] += nodes[node][i];
  return {sum[0] / polygon.size(), sum[1] / polygon.size()};
}

}  // namespace

SplitMesh split(const CoarseMesh& coarse) {
  SplitMesh mesh{coarse.nodes, {}, {}};
  EdgeMiddles middle(mesh.nodes);
  std::vector<std::vector<unsigned>> middles_of_polygon;
  for (const auto& polygon : coarse.polygons) {
    auto& middles = middles_of_polygon.emplace_back();
    for (std::size_t i = 0; i < polygon.size(); ++i)
      middles.push_back(middle(polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  for (std::size_t p = 0; p < coarse.polygons.size(); ++p) {
    const auto& polygon = coarse.polygons[p];
    const auto& middles = middles_of_polygon[p];
    const auto centre = static_cast<unsigned>(mesh.nodes.size());
    mesh.nodes.push_back(mean(coarse.nodes, polygon));
    for (std::size_t i = 0; i < polygon.size(); ++i)
      mesh.cells.push_back({polygon[i], middles[i], centre, middles[(i + polygon.size() - 1) % polygon.size()]});
  }
  for (const auto& [ends, side] : coarse.edges) {
    const unsigned node = middle(ends[0], ends[1]);
    mesh.edges.push_back({{ends[0], node}, side});
    mesh.edges.push_back({{node, ends[1]}, side});
  }
  return mesh;
}

}  // namespace fretval::meshes
