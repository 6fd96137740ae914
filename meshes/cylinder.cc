#include "meshes/cylinder.h"

#include "meshes/body_mesh.h"

namespace fretval::meshes {

Mesh cylinder(const Cylinder& body) {
  return body_mesh({body.contact_nodes, {body.radius, body.thickness}, body.growth}, "cylinder");
}

}  // namespace fretval::meshes
