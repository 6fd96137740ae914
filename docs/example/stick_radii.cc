// Both stick radii of cases/examples/fretting.prm, by the analytic reference alone. SI units, angles in radians.
#include <cmath>
#include <cstdio>

#include "mdr/stick/stick_radius.h"

int main() {
  namespace mdr = fretval::mdr;
  const mdr::Profile indenter = mdr::parabola(1e-2);
  const mdr::PronyBody rubber = mdr::standard_solid(1e6, 1e6, 0.1);
  const mdr::Motion motion{1e-4, 2e-5, 1.5e-5, 1, 1, std::acos(-1.0) / 3};
  const auto radii = mdr::stick_radii(indenter, rubber, 0.5, motion);
  if (!radii.first_slip || !radii.shakedown) return 1;
  std::printf("first slip %.6g, shakedown %.6g\n", *radii.first_slip, *radii.shakedown);
}
