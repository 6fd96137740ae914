#include "comparison/results/moduli_files.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "comparison/support/constants.h"
#include "comparison/support/files.h"

namespace fretval {
namespace {

const double radians_per_cycle = 2 * pi;
constexpr Eigen::Index n_frequencies = 121;

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<double> frequencies_of_interest(const Case& input, const mdr::PronyBody& body) {
  std::vector<double> all;
  for (const double time : body.branch_times) all.push_back(1 / (radians_per_cycle * time));
  if (body.viscosity > 0) all.push_back(body.relaxed_modulus / (radians_per_cycle * body.viscosity));
  if (!input.motion.path) all.insert(all.end(), {input.motion.normal_frequency, input.motion.tangential_frequency});
  if (const auto& curve = input.elastomer.master_curve)
    all.insert(all.end(), curve->frequency.begin(), curve->frequency.end());
  return all;
}

}  // namespace

void write_moduli(const Case& input, const mdr::PronyBody& body, const std::filesystem::path& folder) {
  if (body.branch_times.empty() && !(body.viscosity > 0)) return;
  const auto all = frequencies_of_interest(input, body);
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  const Eigen::VectorXd f =
      Eigen::ArrayXd::LinSpaced(n_frequencies, std::log(*least / 10), std::log(*most * 10)).exp().matrix();
  Eigen::VectorXd storage(n_frequencies), loss(n_frequencies);
  for (Eigen::Index i = 0; i < n_frequencies; ++i) {
    const auto modulus = mdr::complex_modulus(body, radians_per_cycle * f[i]);
    storage[i] = modulus.real();
    loss[i] = modulus.imag();
  }
  write_csv(folder / "moduli.csv", {{"f [Hz]", f}, {"G' [Pa]", storage}, {"G'' [Pa]", loss}});
  if (const auto& curve = input.elastomer.master_curve)
    write_csv(folder / "measured_moduli.csv", {{"f [Hz]", vector_of(curve->frequency)},
                                               {"G' [Pa]", vector_of(curve->storage)},
                                               {"G'' [Pa]", vector_of(curve->loss)}});
}

}  // namespace fretval
