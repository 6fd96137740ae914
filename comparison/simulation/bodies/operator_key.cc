#include "comparison/simulation/bodies/operator_key.h"

#include <fmt/format.h>

#include "comparison/support/versions.h"
#include "fem/support/dense.h"
#include "operators_hash.h"

namespace fretval {
namespace {

/// Part of the key that is the same for all operators which this program makes on this processor.
std::string versions_text() {
  std::string text = "operators " FRETVAL_OPERATORS_HASH "\n";
  for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
  return text + fmt::format("kernels {}\n", fem::dense_kernels());
}

std::string harmonic_text(const fem::FourierOrder& order) {
  return fmt::format("order {}{}\n", order.n, order.is_torsion() ? " torsion" : "");
}

std::string text_of(double value) {
  return fmt::format("{:a}", value);
}
std::string text_of(unsigned value) {
  return fmt::format("{}", value);
}
std::string text_of(const std::string& value) {
  return value;
}
std::string text_of(bool value) {
  return value ? "yes" : "no";
}
std::string text_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += text_of(value) + ' ';
  return text;
}

/// A line for each field, all digits.
std::string lines_of(const BodyDescription& body) {
  std::string text;
  std::apply([&](const auto&... field) { ((text += text_of(field) + '\n'), ...); }, BodyDescription::fields(body));
  return text;
}

}  // namespace

std::string operator_key(const BodyDescription& description, const fem::FourierOrder& order, int n_processes) {
  auto whole = description;
  whole.tangential = true;   // an order serves bodies with and without the other one
  whole.given.file.clear();  // wherever it lies
  auto key = versions_text() + harmonic_text(order) + lines_of(whole);
  if (n_processes > 1) key += fmt::format("processes {}\n", n_processes);
  return key;
}

std::string surface_key(const BodyDescription& description, const fem::FourierOrder& order) {
  return operator_key(description, order) + "all components\n";
}

bool is_of_harmonic(const std::string& key, const fem::FourierOrder& order) {
  return key.find("\n" + harmonic_text(order)) != std::string::npos;
}

bool is_of_this_version(const std::string& key) {
  return key.rfind(versions_text(), 0) == 0;
}

}  // namespace fretval
