#pragma once

#include <functional>

namespace fretval::mdr {

/// The two transforms of MDR for any smooth function, by a quadrature in which the end singularity of the kernel is
/// gone: x = r sin(t). The kinds of mdr/profiles/profile.h have theirs in closed form; this is for profiles given by a
/// formula, and to check those. Relative accuracy 1e-11 for functions that are smooth up to an end singularity.
/// Arguments not negative; std::invalid_argument otherwise, or when the integral does not converge.

/// g(x) = x int_0^x f'(r)/sqrt(x^2-r^2) dr, paper (3). slope: f'.
double abel_transform(const std::function<double(double)>& slope, double x);

/// f(r) = (2/pi) int_0^r g(x)/sqrt(r^2-x^2) dx, paper (4).
double abel_back_transform(const std::function<double(double)>& image, double r);

}  // namespace fretval::mdr
