#include "mdr/rheology/compressible.h"

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

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
  return scaled(body, incompressible_modulus_ratio(poisson_ratio));
}

Rheology incompressible_equivalent(const Rheology& body, double poisson_ratio) {
  const double factor = incompressible_modulus_ratio(poisson_ratio);
  return std::visit([factor](const auto& any) -> Rheology { return scaled(any, factor); }, body);
}

double incompressible_modulus_ratio(double poisson_ratio) {
  require_within("Poisson's ratio", poisson_ratio, 0, 0.5);
  return 1 / (2 * (1 - poisson_ratio));
}

double tangential_stretch(double poisson_ratio) {
  require_within("Poisson's ratio", poisson_ratio, 0, 0.5);
  return 3 * (1 - poisson_ratio) / (2 - poisson_ratio);
}

}  // namespace fretval::mdr
