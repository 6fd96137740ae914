#include "fem/wear/wear_archive.h"

#include <cereal/archives/binary.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <stdexcept>

#include "fem/support/eigen_archive.h"

namespace fretval::fem {

std::string archived(const WearState& state) {
  std::ostringstream stream;
  cereal::BinaryOutputArchive archive(stream);
  archive(state);
  return stream.str();
}

void restore(const std::string& bytes, WearState& state) {
  std::istringstream stream(bytes);
  cereal::BinaryInputArchive archive(stream);
  try {
    archive(state);
  } catch (const std::exception& error) {  // also sizes that no memory holds
    throw std::runtime_error(std::string("no archive of a wear: ") + error.what());
  }
}

}  // namespace fretval::fem
