#include "mdr/motion/force_control.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

#include "mdr/profiles/indentation.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

double indentation_for_force(const Profile& profile, double shear_modulus, double normal_force) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("normal force", normal_force);
  if (normal_force == 0) return 0;
  const auto excess = [&](double indentation) {
    return mdr::normal_force(profile, shear_modulus, indentation) - normal_force;
  };
  const std::uintmax_t most_iterations = 1000;
  std::uintmax_t iterations = most_iterations;
  const auto bracket =
      boost::math::tools::bracket_and_solve_root(excess, std::sqrt(normal_force / shear_modulus), 2.0, true,
                                                 boost::math::tools::eps_tolerance<double>(52), iterations);
  if (iterations >= most_iterations) throw std::runtime_error("the indentation for a normal force was not found");
  return (bracket.first + bracket.second) / 2;
}

double tangential_displacement_for_force(const Profile& profile, double shear_modulus, double mu, double normal_force,
                                         double tangential_force) {
  require_positive("coefficient of friction", mu);
  require_non_negative("normal force", normal_force);
  require_non_negative("tangential force", tangential_force);
  if (tangential_force > mu * normal_force) {
    std::ostringstream limit;
    limit.precision(15);
    limit << "the indenter slides; must be at most mu F = " << mu * normal_force;
    reject("tangential force", tangential_force, limit.str());
  }
  const double indentation = indentation_for_force(profile, shear_modulus, normal_force);
  const double stick_force = std::max(0.0, normal_force - tangential_force / mu);
  return 1.5 * mu * (indentation - indentation_for_force(profile, shear_modulus, stick_force));
}

}  // namespace fretval::mdr
