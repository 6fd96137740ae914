#include "meshes/coarse_mesh.h"

#include <gmsh.h>

#include <cmath>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "meshes/mesh_error.h"

namespace fretval::meshes {
namespace {

/// gmsh, from initialisation to finalisation. Its state is global: one at a time.
class GmshScope {
 public:
  GmshScope() : lock_(mutex()) {
    // A user's own gmsh settings must not change the mesh.
    const bool read_settings = false;
    gmsh::initialize(0, nullptr, read_settings);
    gmsh::option::setNumber("General.Terminal", 0);
  }
  ~GmshScope() {
    gmsh::model::mesh::removeSizeCallback();
    gmsh::finalize();
  }
  GmshScope(const GmshScope&) = delete;
  GmshScope& operator=(const GmshScope&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
};

/// Curves of the geometry, as gmsh tags.
struct Curves {
  std::vector<int> surface;
  std::vector<std::pair<int, Side>> others;
};

/// Geometry of the section without the strip: its upper boundary runs along the bottom of the strip, up its side, and
/// on along the surface.
Curves add_geometry(const std::vector<double>& surface_nodes, double strip_height, const Outline& outline) {
  namespace geo = gmsh::model::geo;
  std::vector<int> upper;
  upper.reserve(surface_nodes.size() + 1);
  for (const double r : surface_nodes) upper.push_back(geo::addPoint(r, -strip_height, 0.));
  if (strip_height > 0) upper.push_back(geo::addPoint(surface_nodes.back(), 0., 0.));
  const int centre = strip_height > 0 ? geo::addPoint(0., 0., 0.) : upper.front();
  const double depth = outline.thickness.value_or(outline.radius);
  const int far = geo::addPoint(outline.radius, 0., 0.), bottom = geo::addPoint(0., -depth, 0.);

  std::vector<int> boundary;
  for (std::size_t i = 1; i < upper.size(); ++i) {
    boundary.push_back(geo::addLine(upper[i - 1], upper[i]));
    geo::mesh::setTransfiniteCurve(boundary.back(), 2);
  }
  Curves curves;
  if (strip_height == 0) curves.surface = boundary;
  boundary.push_back(geo::addLine(upper.back(), far));  // the one without prescribed nodes
  curves.surface.push_back(boundary.back());
  if (outline.thickness) {
    const int corner = geo::addPoint(outline.radius, -depth, 0.);
    curves.others = {{geo::addLine(bottom, corner), Side::base}, {geo::addLine(corner, far), Side::side}};
  } else {
    curves.others = {{geo::addCircleArc(bottom, centre, far), Side::arc}};
  }
  curves.others.emplace_back(geo::addLine(upper.front(), bottom), Side::axis);

  std::vector<int> loop{curves.others.back().first};
  for (std::size_t i = 0; i + 1 < curves.others.size(); ++i) loop.push_back(curves.others[i].first);
  for (auto line = boundary.rbegin(); line != boundary.rend(); ++line) loop.push_back(-*line);
  const int surface = geo::addPlaneSurface({geo::addCurveLoop(loop)});
  geo::mesh::setRecombine(2, surface);
  geo::synchronize();
  return curves;
}

void generate(const std::function<double(double r, double z)>& size) {
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  // 8, made for quadrilaterals, crashes in gmsh 4.8.4.
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  // gmsh shakes nodes by this part of the size of the model; the default, 1e-9, is as large as a small contact element.
  gmsh::option::setNumber("Mesh.RandomFactor", 1e-12);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::model::mesh::setSizeCallback([&size](int, int, double r, double z, double) { return size(r, z); });
  // gmsh meshes surfaces in an OpenMP region, which no exception may leave: it would end the program.
  gmsh::option::setNumber("General.AbortOnError", 1);
  gmsh::model::mesh::generate(2);
  std::string message;
  gmsh::logger::getLastError(message);
  if (!message.empty()) throw MeshError("mesh of the body: gmsh failed: " + message);
}

/// Nodes of all elements of a gmsh type on an entity (-1: all), as indices.
std::vector<unsigned> element_nodes(int type, int entity, const std::map<std::size_t, unsigned>& index) {
  std::vector<std::size_t> elements;
  std::vector<std::size_t> tags;
  gmsh::model::mesh::getElementsByType(type, elements, tags, entity);
  std::vector<unsigned> nodes;
  nodes.reserve(tags.size());
  for (const std::size_t tag : tags) nodes.push_back(index.at(tag));
  return nodes;
}

CoarseMesh extract(const Curves& curves) {
  constexpr int line = 1;
  constexpr int triangle = 2;
  constexpr int quadrilateral = 3;
  CoarseMesh mesh;
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, unsigned> index;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = static_cast<unsigned>(i);
    mesh.nodes.push_back({coordinates[3 * i], coordinates[3 * i + 1]});
  }

  const auto add_polygons = [&](int type, std::size_t n_corners) {
    const auto nodes = element_nodes(type, -1, index);
    for (auto first = nodes.begin(); first != nodes.end(); first += n_corners)
      mesh.polygons.emplace_back(first, first + n_corners);
  };
  add_polygons(triangle, 3);
  add_polygons(quadrilateral, 4);

  const auto add_edges = [&](int curve, Side side) {
    const auto nodes = element_nodes(line, curve, index);
    for (std::size_t i = 0; i < nodes.size(); i += 2) mesh.edges.push_back({{nodes[i], nodes[i + 1]}, side});
  };
  for (const int curve : curves.surface) add_edges(curve, Side::surface);
  for (const auto& [curve, side] : curves.others) add_edges(curve, side);
  return mesh;
}

/// Puts the strip back on the mesh of the rest.
void add_strip(CoarseMesh& mesh, const std::vector<double>& surface_nodes, double height) {
  const double tolerance = 1e-6 * height;
  const auto node_at = [&](double r, double z) {
    unsigned k = 0;
    while (k < mesh.nodes.size() && std::hypot(mesh.nodes[k][0] - r, mesh.nodes[k][1] - z) > tolerance) ++k;
    if (k == mesh.nodes.size()) mesh.nodes.push_back({r, z});
    return k;
  };
  std::vector<unsigned> top, bottom;
  for (const double r : surface_nodes) {
    bottom.push_back(node_at(r, -height));
    top.push_back(node_at(r, 0));
  }
  mesh.edges.push_back({{top.front(), bottom.front()}, Side::axis});
  for (std::size_t i = 1; i < top.size(); ++i) {
    mesh.polygons.push_back({bottom[i - 1], bottom[i], top[i], top[i - 1]});
    mesh.edges.push_back({{top[i - 1], top[i]}, Side::surface});
  }
}

}  // namespace

CoarseMesh coarse_mesh(const std::vector<double>& surface_nodes, double strip_height, const Outline& outline,
                       const std::function<double(double r, double z)>& size) {
  // gmsh throws its messages as bare strings, which nothing that expects a std::exception would understand.
  try {
    const GmshScope scope;
    const Curves curves = add_geometry(surface_nodes, strip_height, outline);
    generate(size);
    CoarseMesh mesh = extract(curves);
    if (strip_height > 0) add_strip(mesh, surface_nodes, strip_height);
    return mesh;
  } catch (const std::string& message) {
    throw MeshError("mesh of the body: gmsh failed: " + message);
  }
}

}  // namespace fretval::meshes
