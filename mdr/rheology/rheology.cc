#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

std::complex<double> complex_modulus(const Rheology& body, double omega) {
  return std::visit([omega](const auto& b) { return complex_modulus(b, omega); }, body);
}

double relaxed_modulus(const Rheology& body) {
  return std::visit([](const auto& b) { return b.relaxed_modulus; }, body);
}

std::complex<double> complex_modulus_ratio(const Rheology& body, double omega) {
  return complex_modulus(body, omega) / relaxed_modulus(body);
}

double modulus_ratio(const Rheology& body, double omega) {
  return std::abs(complex_modulus_ratio(body, omega));
}

}  // namespace fretval::mdr
