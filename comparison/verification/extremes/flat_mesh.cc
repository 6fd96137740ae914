#include "comparison/verification/extremes/flat_mesh.h"

#include <algorithm>
#include <cmath>

namespace fretval {

meshes::Mesh flattened(meshes::Mesh mesh, double aspect, double ring, double reach) {
  const double steepest = std::log(aspect) / std::log(reach / ring);
  for (auto& [r, z] : mesh.nodes) {
    const double x = std::clamp((r / reach - 1) / 2, 0.0, 1.0);
    const double power = steepest * (1 - x * x * (3 - 2 * x));
    if (z < 0 && z > -reach) z *= std::pow(-z / reach, power);
  }
  return mesh;
}

}  // namespace fretval
