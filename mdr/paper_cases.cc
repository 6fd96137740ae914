#include "mdr/paper_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/checks.h"

namespace fretval::mdr {

namespace {

void check(double modulus_ratio, double mu, const Motion& motion) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  require_within("modulus ratio", modulus_ratio, 1, std::numeric_limits<double>::max());
}

}  // namespace

double paper_unlocked_depth(double modulus_ratio, double mu, const Motion& motion) {
  check(modulus_ratio, mu, motion);
  return motion.indentation - modulus_ratio * (1 / mu * 2 / 3 * motion.tangential_amplitude + motion.normal_amplitude);
}

double paper_quadrature_depth(double modulus_ratio, double mu, const Motion& motion) {
  check(modulus_ratio, mu, motion);
  const double tangential = 1 / mu * 2 / 3 * motion.tangential_amplitude;
  return motion.indentation -
         modulus_ratio * std::sqrt(tangential * tangential + motion.normal_amplitude * motion.normal_amplitude);
}

double paper_case_list_depth(double modulus_ratio, double mu, const Motion& motion) {
  check(modulus_ratio, mu, motion);
  require_positive("tangential amplitude", motion.tangential_amplitude);
  require_positive("normal amplitude", motion.normal_amplitude);
  if (!motion.phase) throw std::invalid_argument("phase is unlocked: the case list (24) to (27) needs a fixed phase");

  const double amplitude = motion.normal_amplitude * modulus_ratio;
  const double k = 3 * mu * motion.normal_amplitude / (2 * motion.tangential_amplitude);
  const double cosine = std::cos(*motion.phase);
  const double singular = motion.indentation - amplitude * std::abs(std::sin(*motion.phase));
  // Roundoff can push the radicand below zero where it vanishes, at k = 1 and cos(phi0) = +-1.
  const double c1 = motion.indentation - amplitude / k * std::sqrt(std::max(0.0, k * k - 2 * k * cosine + 1));
  const double c2 = motion.indentation - amplitude / k * std::sqrt(std::max(0.0, k * k + 2 * k * cosine + 1));

  if (cosine <= -1 / k) return std::min(c1, singular);
  if (cosine >= 1 / k) return std::min(c2, singular);
  return std::min({c1, c2, singular});
}

}  // namespace fretval::mdr
