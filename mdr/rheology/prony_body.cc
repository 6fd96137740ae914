#include "mdr/rheology/prony_body.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// The name is put together only for the message: every evaluation of a modulus passes here.
void require_positive_in_branch(const char* quantity, std::size_t i, double value) {
  if (std::isfinite(value) && value > 0) return;
  require_positive(quantity + (" of branch " + std::to_string(i + 1)), value);
}

}  // namespace

PronyBody elastic(double relaxed_modulus) {
  return prony(relaxed_modulus, {}, {});
}

PronyBody kelvin_voigt(double relaxed_modulus, double viscosity) {
  return prony(relaxed_modulus, {}, {}, viscosity);
}

PronyBody standard_solid(double relaxed_modulus, double branch_modulus, double branch_time) {
  return prony(relaxed_modulus, {branch_modulus}, {branch_time});
}

PronyBody prony(double relaxed_modulus, std::vector<double> branch_moduli, std::vector<double> branch_times,
                double viscosity) {
  PronyBody body{relaxed_modulus, std::move(branch_moduli), std::move(branch_times), viscosity};
  validate(body);
  return body;
}

void validate(const PronyBody& body) {
  if (body.relaxed_modulus == 0) {
    reject("relaxed modulus", 0,
           "a Maxwell body has no relaxed modulus, so no permanent stick; must be finite and positive");
  }
  require_positive("relaxed modulus", body.relaxed_modulus);
  require_non_negative("viscosity", body.viscosity);
  if (body.branch_moduli.size() != body.branch_times.size()) {
    throw std::invalid_argument("number of branch moduli = " + std::to_string(body.branch_moduli.size()) +
                                ": must equal the number of branch times, " + std::to_string(body.branch_times.size()));
  }
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) {
    require_positive_in_branch("modulus", i, body.branch_moduli[i]);
    require_positive_in_branch("relaxation time", i, body.branch_times[i]);
  }
}

std::complex<double> complex_modulus(const PronyBody& body, double omega) {
  validate(body);
  require_non_negative("angular frequency", omega);
  std::complex<double> modulus(body.relaxed_modulus, omega * body.viscosity);
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) {
    const double x = omega * body.branch_times[i];
    // In this form neither part cancels or becomes inf/inf, even if x underflows to 0 or overflows.
    const double inverse = 1 / x;
    modulus += body.branch_moduli[i] * std::complex<double>(1 / (1 + inverse * inverse), 1 / (x + inverse));
  }
  return modulus;
}

double relaxation(const PronyBody& body, double time) {
  validate(body);
  require_non_negative("time", time);
  double modulus = body.relaxed_modulus;
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) {
    modulus += body.branch_moduli[i] * std::exp(-time / body.branch_times[i]);
  }
  return modulus;
}

}  // namespace fretval::mdr
