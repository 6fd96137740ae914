#include "mdr/support/exponential_sum.h"

#include <algorithm>
#include <cmath>

namespace fretval::mdr {
namespace {

/// A bound of |f''| from s on.
double bend_from(const ExponentialSum& f, double s) {
  double bend = 0;
  for (std::size_t i = 0; i < f.rates.size(); ++i)
    bend += std::abs(f.coefficients[i]) * f.rates[i] * f.rates[i] * std::exp(-f.rates[i] * s);
  return bend;
}

struct Interval {
  double begin, end, at_begin, at_end;
};

}  // namespace

double ExponentialSum::operator()(double s) const {
  double sum = constant + slope * s;
  for (std::size_t i = 0; i < rates.size(); ++i) sum += coefficients[i] * std::exp(-rates[i] * s);
  return sum;
}

double supremum(const ExponentialSum& f, double length, double error) {
  std::vector<Interval> open{{0, length, f(0), f(length)}};
  double largest = std::max(open.front().at_begin, open.front().at_end);
  while (!open.empty()) {
    const auto [begin, end, at_begin, at_end] = open.back();
    open.pop_back();
    const double h = end - begin, bound = std::max(at_begin, at_end) + bend_from(f, begin) * h * h / 8;
    if (bound <= largest + error) continue;
    const double middle = begin + h / 2, at_middle = f(middle);
    if (!(begin < middle && middle < end)) continue;  // roundoff
    largest = std::max(largest, at_middle);
    open.push_back({begin, middle, at_begin, at_middle});
    open.push_back({middle, end, at_middle, at_end});
  }
  return largest + error;
}

}  // namespace fretval::mdr
