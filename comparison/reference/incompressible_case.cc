#include "comparison/reference/incompressible_case.h"

#include "mdr/rheology/compressible.h"

namespace fretval {
namespace {

void scale_moduli(Case::Elastomer& elastomer, double factor) {
  elastomer.relaxed_modulus *= factor;
  elastomer.viscosity *= factor;
  for (double& modulus : elastomer.branch_moduli) modulus *= factor;
}

void scale_displacements(Case::Motion& motion, double factor) {
  if (motion.path && !motion.path->tangential_force)
    for (auto* column : {&motion.path->tangential, &motion.path->transverse})
      for (double& displacement : *column) displacement *= factor;
  motion.tangential_amplitude *= factor;
  if (motion.tangential_force) return;
  for (auto* harmonics : {&motion.tangential_harmonics, &motion.transverse})
    for (auto& harmonic : *harmonics) harmonic.amplitude *= factor;
}

}  // namespace

bool is_layer_of_mdr(const Case& input) {
  return input.body.shape == Case::Body::Shape::layer && !input.motion.moves_across();
}

IncompressibleCase incompressible_case(const Case& input) {
  const double nu = input.elastomer.poisson_ratio;
  IncompressibleCase equivalent{input};
  if (nu == 0.5 || is_layer_of_mdr(input)) return equivalent;
  equivalent.displacement = mdr::tangential_stretch(nu);
  equivalent.input.elastomer.poisson_ratio = 0.5;
  scale_moduli(equivalent.input.elastomer, mdr::incompressible_modulus_ratio(nu));
  scale_displacements(equivalent.input.motion, equivalent.displacement);
  return equivalent;
}

}  // namespace fretval
