#include "comparison/simulation/surface_answer.h"

namespace fretval {

PlaneEdges edges_of(const SurfaceAnswer& surface) {
  PlaneEdges edges;
  for (const auto& point : fem::whole_circle(surface.grid)) {
    const auto kept = static_cast<std::size_t>(point.kept);
    edges.angle.push_back(point.angle);
    edges.contact.push_back(surface.contact.edges[kept]);
    edges.never_slipped.push_back(surface.never_slipped.edges[kept]);
    edges.sticks_in_a_cycle.push_back(surface.sticks_in_a_cycle.edges[kept]);
  }
  return edges;
}

}  // namespace fretval
