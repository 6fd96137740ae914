#include "mdr/rheology/fractional_zener.h"

#include <cmath>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

void validate(const FractionalZener& body) {
  require_positive("relaxed modulus", body.relaxed_modulus);
  require_non_negative("branch modulus", body.branch_modulus);
  require_positive("relaxation time", body.branch_time);
  if (!(body.order > 0 && body.order <= 1)) reject("fractional order", body.order, "must be above 0 and at most 1");
}

std::complex<double> complex_modulus(const FractionalZener& body, double omega) {
  validate(body);
  require_non_negative("angular frequency", omega);
  if (omega == 0) return body.relaxed_modulus;
  const double quarter_turns = body.order * (pi / 2);
  const double magnitude = std::pow(omega * body.branch_time, -body.order);
  // 1/(1 + z^-1) neither overflows nor cancels, whatever the size of z = (i omega tau)^alpha.
  return body.relaxed_modulus + body.branch_modulus / (1.0 + std::polar(magnitude, -quarter_turns));
}

}  // namespace fretval::mdr
