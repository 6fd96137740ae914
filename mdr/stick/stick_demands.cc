#include "mdr/stick/stick_demands.h"

#include <algorithm>
#include <cmath>

namespace fretval::mdr {

// |T e^(i phase) -+ N| is written as hypot(T - N, 2 sqrt(T N) sin or cos(phase/2)), which is free of cancellation at
// phase = 0, pi and T = N.
StickDemands locked_demands(double tangential, double normal, double phase) {
  const double cross = 2 * std::sqrt(tangential) * std::sqrt(normal);
  return {std::hypot(tangential - normal, cross * std::sin(phase / 2)),
          std::hypot(tangential - normal, cross * std::cos(phase / 2))};
}

StickDemands unlocked_demands(double tangential, double normal) {
  return {tangential + normal, tangential + normal};
}

double first_slip_demand(const StickDemands& demands) {
  return std::max(demands.forward, demands.backward);
}

double shakedown_demand(const StickDemands& demands) {
  return (demands.forward + demands.backward) / 2;
}

}  // namespace fretval::mdr
