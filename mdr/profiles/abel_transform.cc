#include "mdr/profiles/abel_transform.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <stdexcept>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// A function that is not finite gives NaN instead of an exception of the library's own.
using Policy =
    boost::math::policies::policy<boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;

// int_0^(pi/2) f(r sin t) dt
double quarter_turn_integral(const std::function<double(double)>& f, double r) {
  require_non_negative("radius of the transform", r);
  boost::math::quadrature::tanh_sinh<double, Policy> quadrature;
  double error = 0, size = 0;
  const double integral =
      quadrature.integrate([&](double t) { return f(r * std::sin(t)); }, 0.0, pi / 2, 1e-13, &error, &size);
  if (!std::isfinite(integral) || error > 1e-8 * size)
    throw std::invalid_argument("the Abel integral does not converge: the function is singular or too rough");
  return integral;
}

}  // namespace

double abel_transform(const std::function<double(double)>& slope, double x) {
  return x == 0 ? 0 : x * quarter_turn_integral(slope, x);
}

double abel_back_transform(const std::function<double(double)>& image, double r) {
  return quarter_turn_integral(image, r) / (pi / 2);
}

}  // namespace fretval::mdr
