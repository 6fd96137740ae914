#include "mdr/layer/layer_response.h"

#include <cmath>
#include <stdexcept>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// sinh x - x, without the difference for small x.
double sinh_less_x(double x) {
  if (x > 1) return std::sinh(x) - x;
  const double square = x * x;
  double sum = 1;
  for (int k = 17; k >= 5; k -= 2) sum = 1 + sum * square / (k * (k - 1));
  return sum * x * square / 6;
}

// All below is multiplied by 4 e^(-2 kappa), so that nothing overflows; once = e^(-2 kappa), less_one = 1 - once.
struct Bonded {
  double kappa, nu, once, less_one, denominator;

  Bonded(double wave, double poisson_ratio)
      : kappa(wave), nu(poisson_ratio), once(std::exp(-2 * wave)), less_one(-std::expm1(-2 * wave)) {
    denominator = 4 * once * (kappa * kappa + 4 * (1 - nu) * (1 - nu)) + (3 - 4 * nu) * less_one * less_one;
  }

  // (3-4 nu) s c + sign kappa over D.
  [[nodiscard]] double ratio(int sign) const {
    const double slow = sign < 0 ? 2 - 4 * nu : 4 - 4 * nu;  // of kappa, s c ~ kappa taken out
    if (kappa > 1) return ((3 - 4 * nu) * less_one * (1 + once) + 4 * once * sign * kappa) / denominator;
    return 4 * once * ((3 - 4 * nu) * sinh_less_x(2 * kappa) / 2 + slow * kappa) / denominator;
  }

  [[nodiscard]] double ratio_less_one(int sign) const {
    const double rest = (3 - 4 * nu) * less_one / 2 + sign * kappa - kappa * kappa - 4 * (1 - nu) * (1 - nu);
    return 4 * once * rest / denominator;
  }
};

void check(const Layer& layer, Direction direction, double kappa) {
  validate(layer);
  require_non_negative("wave number times thickness", kappa);
  if (layer.base == LayerBase::frictionless && direction == Direction::tangential)
    throw std::invalid_argument(
        "base of the layer = frictionless: nothing holds the layer against a tangential motion; must be bonded");
}

}  // namespace

double response_ratio(const Layer& layer, Direction direction, double kappa) {
  check(layer, direction, kappa);
  const double nu = layer.poisson_ratio;
  if (layer.base == LayerBase::frictionless) {
    const double once = std::exp(-2 * kappa), less_one = -std::expm1(-2 * kappa);
    return kappa > 0 ? less_one * less_one / (less_one * (1 + once) + 4 * kappa * once) : 0;
  }
  const Bonded bonded(kappa, nu);
  if (direction == Direction::normal) return bonded.ratio(-1);
  return ((1 - nu) * bonded.ratio(1) + std::tanh(kappa)) / (2 - nu);
}

double response_ratio_less_one(const Layer& layer, Direction direction, double kappa) {
  check(layer, direction, kappa);
  const double nu = layer.poisson_ratio, once = std::exp(-2 * kappa), less_one = -std::expm1(-2 * kappa);
  if (layer.base == LayerBase::frictionless)
    return kappa > 0 ? -2 * once * (less_one + 2 * kappa) / (less_one * (1 + once) + 4 * kappa * once) : -1;
  const Bonded bonded(kappa, nu);
  if (direction == Direction::normal) return bonded.ratio_less_one(-1);
  return ((1 - nu) * bonded.ratio_less_one(1) - 2 * once / (1 + once)) / (2 - nu);
}

}  // namespace fretval::mdr
