#include "comparison/simulation/bodies/operator_key.h"

#include <fmt/format.h>

#include "comparison/support/versions.h"
#include "fem/support/dense.h"
#include "operators_hash.h"

namespace fretval {
namespace {

/// What is the same for all operators that this program makes on this processor.
std::string versions_text() {
  std::string text = "operators " FRETVAL_OPERATORS_HASH "\n";
  for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
  return text + fmt::format("kernels {}\n", fem::dense_kernels());
}

std::string harmonic_text(fem::Harmonic harmonic) {
  return fmt::format("harmonic {}\n", static_cast<int>(harmonic));
}

}  // namespace

std::string operator_key(const BodySpecification& specification, fem::Harmonic harmonic, int n_processes) {
  auto key = versions_text() + harmonic_text(harmonic) + "Poisson's ratio 0.5\n";
  key += fmt::format("degree {}\ngrowth {:a}\nfar radius {:a}\nscale {:a}\ncontact nodes", specification.degree,
                     specification.growth, specification.far_radius, specification.scale);
  for (const double node : specification.contact_nodes) key += fmt::format(" {:a}", node);
  if (n_processes > 1) key += fmt::format("\nprocesses {}", n_processes);
  return key + "\n";
}

bool is_of_harmonic(const std::string& key, fem::Harmonic harmonic) {
  return key.find("\n" + harmonic_text(harmonic)) != std::string::npos;
}

bool is_of_this_version(const std::string& key) {
  return key.rfind(versions_text(), 0) == 0;
}

}  // namespace fretval
