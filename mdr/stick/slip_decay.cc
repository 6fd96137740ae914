#include "mdr/stick/slip_decay.h"

#include <algorithm>
#include <cmath>

#include "mdr/support/checks.h"

namespace fretval::mdr {

std::optional<double> slip_decay(const PronyBody& body, double period) {
  validate(body);
  require_positive("period", period);
  const auto& times = body.branch_times;
  if (times.empty() || body.viscosity > 0) return std::nullopt;
  // The root is found as 1 - lambda, which may be small: it lies between 0 and the smallest 1 - q.
  const auto short_of_one = [period](double time) { return -std::expm1(-period / time); };
  double lower = 0, upper = short_of_one(*std::max_element(times.begin(), times.end()));
  const auto excess = [&](double x) {
    double sum = body.relaxed_modulus;
    for (std::size_t i = 0; i < times.size(); ++i) sum -= body.branch_moduli[i] * x / (short_of_one(times[i]) - x);
    return sum;
  };
  while (true) {
    const double middle = (lower + upper) / 2;
    if (!(middle > lower && middle < upper)) return 1 - middle;
    (excess(middle) > 0 ? lower : upper) = middle;
  }
}

}  // namespace fretval::mdr
