#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "mdr/profiles/profile_csv.h"
#include "mdr/rheology/modulus_table.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void read_profile(std::istream& stream, double noise) {
  using namespace fretval::mdr;
  const Profile profile = read_profile_table(stream, "table.csv", noise);
  require(std::isfinite(shape(profile, 0)) && std::isfinite(transform(profile, 0)));
}

void read_moduli(std::istream& stream) {
  using namespace fretval::mdr;
  const ModulusTable table = read_modulus_table(stream, "table.csv");
  validate(table);
}

}  // namespace

/// The first byte chooses the reader: a profile through the points, a profile with noise, or moduli.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  try {
    if (data[0] % 3 == 2) {
      read_moduli(stream);
    } else {
      read_profile(stream, data[0] % 3 == 0 ? 0 : 1e-6);
    }
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
