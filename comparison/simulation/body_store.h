#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "comparison/simulation/body.h"

namespace fretval {

/// Where meshes come from: made for each specification unless somebody has others, as the small committed ones.
struct MeshSource {
  std::string name = "generated mesh";  ///< for messages
  std::function<meshes::Mesh(const BodySpecification&)> mesh_of = fretval::mesh_of;
};

/// The bodies that cases and their refinements share: each is made once, for all threads.
class BodyStore {
 public:
  explicit BodyStore(MeshSource meshes = {}) : meshes_(std::move(meshes)) {}

  [[nodiscard]] const MeshSource& meshes() const { return meshes_; }

  /// The body of that specification; makes it if nobody has, and waits where another thread is making it. Throws what
  /// make throws, whoever asks.
  std::shared_ptr<const ContactBody> find_or_make(const BodySpecification& specification,
                                                  const std::function<ContactBody()>& make);

 private:
  using Future = std::shared_future<std::shared_ptr<const ContactBody>>;
  MeshSource meshes_;
  std::map<BodySpecification, Future> bodies_;
  std::mutex mutex_;
};

}  // namespace fretval
