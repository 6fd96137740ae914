#pragma once

#include <stdexcept>

namespace fretval::meshes {

/// A mesh that cannot be made, read or trusted. The message reads "file or mesh: what, its value, what would be valid".
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fretval::meshes
