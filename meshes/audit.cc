#include "meshes/audit.h"

#include "meshes/audit_boundary.h"
#include "meshes/audit_cells.h"

namespace fretval::meshes {

void audit(const Mesh& mesh, const std::string& name) {
  audit_indices(mesh, name);
  audit_nodes(mesh, name);
  audit_cells(mesh, name);
  audit_node_use(mesh, name);
  audit_edges(mesh, name);
  audit_parts_of_boundary(mesh, name);
  audit_contact_line(mesh, name);
  audit_body(mesh, name);
}

}  // namespace fretval::meshes
