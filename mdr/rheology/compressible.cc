#include "mdr/rheology/compressible.h"

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

double modulus_factor(double poisson_ratio) {
  require_within("Poisson's ratio", poisson_ratio, 0, 0.5);
  return 1 / (2 * (1 - poisson_ratio));
}

PronyBody scaled(PronyBody body, double factor) {
  body.relaxed_modulus *= factor;
  for (double& modulus : body.branch_moduli) modulus *= factor;
  body.viscosity *= factor;
  return body;
}

FractionalZener scaled(FractionalZener body, double factor) {
  body.relaxed_modulus *= factor;
  body.branch_modulus *= factor;
  return body;
}

}  // namespace

PronyBody incompressible_equivalent(const PronyBody& body, double poisson_ratio) {
  return scaled(body, modulus_factor(poisson_ratio));
}

Rheology incompressible_equivalent(const Rheology& body, double poisson_ratio) {
  const double factor = modulus_factor(poisson_ratio);
  return std::visit([factor](const auto& any) -> Rheology { return scaled(any, factor); }, body);
}

double tangential_stretch(double poisson_ratio) {
  require_within("Poisson's ratio", poisson_ratio, 0, 0.5);
  return 3 * (1 - poisson_ratio) / (2 - poisson_ratio);
}

}  // namespace fretval::mdr
