#pragma once

#include <functional>
#include <memory>
#include <string>

#include "comparison/simulation/body.h"
#include "comparison/simulation/normal_store.h"
#include "comparison/support/made_once.h"

namespace fretval {

/// Where meshes come from: made for each specification unless somebody has others, as the small committed ones.
struct MeshSource {
  std::string name = "generated mesh";  ///< for messages
  std::function<meshes::Mesh(const BodySpecification&)> mesh_of = fretval::mesh_of;
};

/// The bodies that cases and their refinements share, with the normal histories on them.
class BodyStore : public MadeOnce<BodySpecification, ContactBody> {
 public:
  explicit BodyStore(MeshSource source = {}) : meshes(std::move(source)) {}
  const MeshSource meshes;
  NormalStore normals;
};

/// Mesh, operators and condensation of a specification, unless the store has them. whole: set to the whole body if it
/// had to be made.
std::shared_ptr<const ContactBody> find_or_make_body(const BodySpecification& specification, BodyStore& bodies,
                                                     std::shared_ptr<const Body>* whole = nullptr);

}  // namespace fretval
