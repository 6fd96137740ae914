#include "meshes/quarter_disc.h"

#include "meshes/body_mesh.h"

namespace fretval::meshes {

Mesh quarter_disc(const QuarterDisc& disc) {
  return body_mesh({disc.contact_nodes, {disc.far_radius}, disc.growth}, "quarter disc");
}

}  // namespace fretval::meshes
