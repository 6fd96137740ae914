#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "fem/ring_contact/effective_radii.h"
#include "fem/support/constants.h"
#include "fem/wear/rubbing_rings.h"
#include "fem/wear/wear_course.h"
#include "tests/fem/half_space.h"

namespace fretval::fem {

/// A parabola of radius of curvature 1 that wears on the half-space, largest indentation 1, contact line to 1.375. At a
/// quarter of a cycle between both motions the shakedown radius of an elastic body is 0.625, a node:
/// `g(c) = c^2 = d0 - sqrt(A^2 + Dd^2)`, A = 2 u_x0 / (3 mu).
struct WearingHalfSpace {
  static constexpr double mu = 0.5, stick_radius = 0.625, mean_indentation = 0.8, normal_amplitude = 0.2;

  explicit WearingHalfSpace(unsigned n_per_radius = 32)
      : normal(long_half_space(axisymmetric, n_per_radius)),
        tangential(long_half_space(lateral, n_per_radius)),
        profile(ring_means(normal.compliance, [](double r) { return r * r / 2; })) {
    const double both = mean_indentation - stick_radius * stick_radius;
    const double a = std::sqrt(both * both - normal_amplitude * normal_amplitude);
    motion = one_frequency(mean_indentation, normal_amplitude, 1.5 * mu * a, pi / 2);
    motion.n_ramp_cycles = 2;
  }

  [[nodiscard]] WearingContact contact_at_rest(const WearLaw& law) const {
    const WornProfile shape{profile, Eigen::VectorXd::Zero(profile.size())};
    return {std::make_unique<RubbingRings>(normal, tangential, body, motion, n_steps, shape, mu), law};
  }
  /// In motion.
  [[nodiscard]] WearingContact contact(const WearLaw& law) const {
    auto contact = contact_at_rest(law);
    contact.start();
    return contact;
  }

  /// Until nothing is left, unless told otherwise.
  [[nodiscard]] WearCourse course(const WearLaw& law, double jump = 0.01, double most_cycles = infinity,
                                  double rate = 0) const {
    WearState state{contact_at_rest(law)};
    wear_on(state, {most_cycles, rate, jump, 1e-6});
    return state.course;
  }

  /// The disc that the stuck rings stand for.
  [[nodiscard]] double effective_stick_radius() const {
    const auto& radii = normal.compliance.radii;
    const auto n = std::count_if(radii.begin() + 1, radii.end(), [](double r) { return r <= stick_radius; });
    return effective_radii(normal.compliance).radius[n];
  }

  /// Height of the limiting profile of a stick radius c, and of the unworn one beyond (docs/theory.md). Forces are to
  /// press 1 deep.
  [[nodiscard]] double limit(double r, double c) const {
    const double deepest = motion.normal_force ? 1 : motion.indentation + motion.normal[0].amplitude;
    if (r <= c) return r * r / 2;
    const double worn =
        (r * r * std::asin(c / r) - c * std::sqrt(r * r - c * c)) / pi + 2 / pi * deepest * std::acos(c / r);
    return std::max(worn, r * r / 2);
  }

  /// Largest distance in height from the limiting profile of the disc that sticks, of the rings from an eighth beyond,
  /// as the limit is vertical at c.
  [[nodiscard]] double distance_from_limit(const Eigen::VectorXd& worn) const {
    const auto& radii = normal.compliance.radii;
    const double c = effective_stick_radius();
    double largest = 0;
    for (Eigen::Index i = 0; i < worn.size(); ++i) {
      if (radii[i] >= stick_radius && radii[i] < stick_radius + 0.125) continue;
      const double r = std::hypot(radii[i], radii[i + 1]) / std::sqrt(2);
      largest = std::max(largest, std::abs(profile[i] + worn[i] - limit(r, c)));
    }
    return largest;
  }

  const ContactProblem &normal, &tangential;
  RelaxationModel body;
  Motion motion;
  int n_steps = 72;
  Eigen::VectorXd profile;
};

}  // namespace fretval::fem
