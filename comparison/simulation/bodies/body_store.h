#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/bodies/distributed_body.h"
#include "comparison/simulation/bodies/normal_store.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "comparison/support/made_once.h"

namespace fretval {

/// Where meshes come from: they are made for each description unless others are given, such as the small committed
/// ones.
struct MeshSource {
  std::string name = "generated mesh";  ///< for messages
  std::function<meshes::Mesh(const BodyDescription&)> mesh_of = fretval::mesh_of;
};

/// Blocks of the surfaces of bodies (fem::surface_block), shared by cases, numbers of angles and refinements.
using SurfaceStore = MadeOnce<std::pair<BodyDescription, fem::FourierOrder>, fem::Compliance>;

/// The bodies that cases and their refinements share, with the normal histories on them.
class BodyStore : public MadeOnce<BodyDescription, ContactBody> {
 public:
  explicit BodyStore(MeshSource source = {}) : meshes(std::move(source)) {}
  /// Bodies on generated meshes, whose operators are shared with other runs by a store on disk. Null: they are not.
  explicit BodyStore(std::shared_ptr<OperatorStore> kept) : operators(std::move(kept)) {}
  const MeshSource meshes;
  const std::shared_ptr<OperatorStore> operators;  ///< null: none; other meshes are no part of its keys
  std::optional<Distribution> distribution;        ///< set before the first body is asked for; empty: none is too large
  NormalStore normals;
  SurfaceStore surfaces;
  std::atomic<int> n_made{0}, n_kept{0};  ///< bodies that were made, and that came from the store of operators
};

/// Whether bodies of n_dofs are made by all processes together.
bool is_too_large(std::size_t n_dofs, const BodyStore& bodies);

/// Mesh, operators and condensation of a description, unless the store, or that of its operators, has them, at any
/// scale. whole: set to the whole body if it had to be made, in this process alone and at a scale of 1.
std::shared_ptr<const ContactBody> find_or_make_body(const BodyDescription& description, BodyStore& bodies,
                                                     std::shared_ptr<const Body>* whole = nullptr);

}  // namespace fretval
