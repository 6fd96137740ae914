#include "mdr/layer/layer.h"

#include <cmath>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

void require_poisson_ratio(double poisson_ratio) {
  require_within("Poisson's ratio", poisson_ratio, 0, 0.5);
}

}  // namespace

void validate(const Layer& layer) {
  if (!std::isinf(layer.thickness) || layer.thickness < 0) require_positive("thickness of the layer", layer.thickness);
  require_poisson_ratio(layer.poisson_ratio);
}

double spring_modulus(Direction direction, double poisson_ratio) {
  require_poisson_ratio(poisson_ratio);
  return direction == Direction::normal ? 2 / (1 - poisson_ratio) : 4 / (2 - poisson_ratio);
}

double spring_modulus_ratio(double poisson_ratio) {
  require_poisson_ratio(poisson_ratio);
  return (2 - poisson_ratio) / (2 * (1 - poisson_ratio));
}

}  // namespace fretval::mdr
