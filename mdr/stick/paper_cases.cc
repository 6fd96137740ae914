#include "mdr/stick/paper_cases.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/trigonometric_maximum.h"

namespace fretval::mdr {

namespace {

void check(double modulus_ratio, double mu, const Motion& motion) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  require_within("modulus ratio", modulus_ratio, 1, std::numeric_limits<double>::max());
}

void require_phase(const Motion& motion, const char* equation) {
  if (!motion.phase)
    throw std::invalid_argument(std::string("phase is unlocked: ") + equation + " needs a fixed phase");
}

// The two oscillations in (18), relative to G'(0).
struct ModulusParts {
  double storage;
  double loss;
};

ModulusParts modulus_parts(const Rheology& body, double mu, const Motion& motion) {
  check(1, mu, motion);
  require_phase(motion, "(18)");
  if (motion.normal_frequency != motion.tangential_frequency)
    throw std::invalid_argument("normal and tangential frequency differ: (18) has one");
  const std::complex<double> ratio = complex_modulus_ratio(body, angular_frequency(motion.normal_frequency));
  return {ratio.real(), ratio.imag()};
}

}  // namespace

double paper_no_slip_depth_at_time(const Rheology& body, double mu, const Motion& motion, double time) {
  const auto [storage, loss] = modulus_parts(body, mu, motion);
  require_finite("time", time);
  const double angle = angular_frequency(motion.normal_frequency) * time;
  const double pull = storage * std::cos(angle + *motion.phase) - loss * std::sin(angle + *motion.phase);
  const double push = storage * std::cos(angle) - loss * std::sin(angle);
  return motion.indentation -
         (1 / mu * 2 / 3 * motion.tangential_amplitude * std::abs(pull) - motion.normal_amplitude * push);
}

double paper_least_no_slip_depth(const Rheology& body, double mu, const Motion& motion) {
  const auto [storage, loss] = modulus_parts(body, mu, motion);
  const double tangential = 1 / mu * 2 / 3 * motion.tangential_amplitude;
  const double quarter_turn = pi / 2;
  double demand = 0;
  for (const double sign : {1.0, -1.0}) {
    // -sin(x) = cos(x + pi/2)
    demand = std::max(demand, trigonometric_maximum({{sign * tangential * storage, 1, *motion.phase},
                                                     {sign * tangential * loss, 1, *motion.phase + quarter_turn},
                                                     {-motion.normal_amplitude * storage, 1, 0},
                                                     {-motion.normal_amplitude * loss, 1, quarter_turn}})
                                  .value);
  }
  return motion.indentation - demand;
}

double paper_no_slip_depth(double modulus_ratio, double mu, const Motion& motion, double angle) {
  check(modulus_ratio, mu, motion);
  require_phase(motion, "(20)");
  require_finite("angle", angle);
  return motion.indentation -
         modulus_ratio * (1 / mu * 2 / 3 * motion.tangential_amplitude * std::abs(std::cos(angle + *motion.phase)) -
                          motion.normal_amplitude * std::cos(angle));
}

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

double paper_amplitude_ratio(double mu, const Motion& motion) {
  check(1, mu, motion);
  require_positive("tangential amplitude", motion.tangential_amplitude);
  return 3 * mu * motion.normal_amplitude / (2 * motion.tangential_amplitude);
}

PaperCandidates paper_candidates(double modulus_ratio, double mu, const Motion& motion) {
  check(modulus_ratio, mu, motion);
  require_positive("normal amplitude", motion.normal_amplitude);
  require_phase(motion, "the case list (24) to (27)");
  const double k = paper_amplitude_ratio(mu, motion), d0 = motion.indentation;
  const double amplitude = motion.normal_amplitude * modulus_ratio;
  const double cosine = std::cos(*motion.phase), sine = std::sin(*motion.phase);
  // Roundoff can push the radicand below zero where it vanishes, at k = 1 and cos(phi0) = +-1.
  return {d0 - amplitude / k * std::sqrt(std::max(0.0, k * k - 2 * k * cosine + 1)),
          d0 - amplitude / k * std::sqrt(std::max(0.0, k * k + 2 * k * cosine + 1)), d0 + amplitude * sine,
          d0 - amplitude * sine};
}

double paper_case_list_depth(double modulus_ratio, double mu, const Motion& motion) {
  const auto [c1, c2, c3, c4] = paper_candidates(modulus_ratio, mu, motion);
  const double k = paper_amplitude_ratio(mu, motion), cosine = std::cos(*motion.phase);
  if (cosine <= -1 / k) return std::min({c1, c3, c4});
  if (cosine >= 1 / k) return std::min({c2, c3, c4});
  return std::min({c1, c2, c3, c4});
}

}  // namespace fretval::mdr
