#include "mdr/rheology/prony_approximation.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "mdr/motion/motion.h"
#include "mdr/support/checks.h"
#include "mdr/support/non_negative_least_squares.h"

namespace fretval::mdr {

namespace {

constexpr int samples_per_decade = 20;
constexpr int branches_per_decade = 4;
constexpr double reach = 10;           // of the branches beyond the range
constexpr double longest_reach = 1e3;  // likewise, to the side of a relaxation time that lies further off

Eigen::ArrayXd log_spaced(double from, double to, int per_decade) {
  const auto n = static_cast<Eigen::Index>(std::ceil(std::log10(to / from) * per_decade - 1e-9));
  return from * (Eigen::ArrayXd::LinSpaced(n + 1, 0, static_cast<double>(n)) * (std::log(10.0) / per_decade)).exp();
}

// Relaxation times that include the body's own where the range lets them reach it, so that order 1 is exact.
Eigen::ArrayXd branch_times(const FractionalZener& body, double slow, double fast) {
  const double shortest = 1 / (reach * fast);
  const double longest = std::clamp(reach * body.branch_time, reach / slow, longest_reach / slow);
  const double steps = std::floor(std::log10(body.branch_time / shortest) * branches_per_decade);
  return log_spaced(body.branch_time * std::pow(10, -steps / branches_per_decade), longest, branches_per_decade);
}

}  // namespace

PronyApproximation prony_approximation(const FractionalZener& body, double lowest_frequency, double highest_frequency) {
  validate(body);
  require_positive("lowest frequency", lowest_frequency);
  require_positive("highest frequency", highest_frequency);
  if (!(lowest_frequency < highest_frequency))
    reject("lowest frequency", lowest_frequency, "must be less than the highest one");
  const double slow = angular_frequency(lowest_frequency), fast = angular_frequency(highest_frequency);
  const Eigen::ArrayXd omega = log_spaced(slow, fast, samples_per_decade);
  const Eigen::ArrayXd times = branch_times(body, slow, fast);
  Eigen::MatrixXd responses(2 * omega.size(), times.size());
  Eigen::VectorXd target(2 * omega.size());
  for (Eigen::Index k = 0; k < omega.size(); ++k) {
    const std::complex<double> modulus = complex_modulus(body, omega[k]);
    const Eigen::ArrayXd x = omega[k] * times, loss = 1 / (x + 1 / x);
    responses.row(2 * k) = (x * loss / std::abs(modulus)).matrix().transpose();
    responses.row(2 * k + 1) = (loss / std::abs(modulus)).matrix().transpose();
    target[2 * k] = (modulus.real() - body.relaxed_modulus) / std::abs(modulus);
    target[2 * k + 1] = modulus.imag() / std::abs(modulus);
  }
  const Eigen::VectorXd moduli = non_negative_least_squares(responses, target);
  PronyApproximation result{elastic(body.relaxed_modulus), 0};
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    if (moduli[i] == 0) continue;
    result.body.branch_moduli.push_back(moduli[i]);
    result.body.branch_times.push_back(times[i]);
  }
  for (const double w : omega) {
    const std::complex<double> modulus = complex_modulus(body, w);
    result.worst = std::max(result.worst, std::abs(complex_modulus(result.body, w) - modulus) / std::abs(modulus));
  }
  return result;
}

}  // namespace fretval::mdr
