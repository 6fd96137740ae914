#include "mdr/layer/layer_stick_radius.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// Normal contacts between two radii, by which everything that depends on the radius smoothly is a polynomial in it.
struct ContactFamily {
  std::vector<LayerContact> contacts;
  Eigen::ArrayXd radius, share;  // nodes of Chebyshev, and their barycentric weights

  ContactFamily(const Profile& profile, const Layer& layer, double least, double most) {
    constexpr int n = 16;
    radius.resize(n);
    share.resize(n);
    for (int k = 0; k < n; ++k) {
      const double angle = pi * (k + 0.5) / n;
      radius[k] = (least + most) / 2 - (most - least) / 2 * std::cos(angle);
      share[k] = (k % 2 == 0 ? 1 : -1) * std::sin(angle);
      contacts.push_back(layer_contact(profile, layer, radius[k]));
    }
  }

  [[nodiscard]] double at(const Eigen::ArrayXd& values, double a) const {
    double sum = 0, weights = 0;
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      if (a == radius[k]) return values[k];
      const double weight = share[k] / (a - radius[k]);
      sum += weight * values[k];
      weights += weight;
    }
    return sum / weights;
  }
};

struct Samples {
  std::vector<double> normal, tangential;  // of one period, equal steps
  bool locked;
};

double sum_of(const std::vector<Harmonic>& harmonics, double time) {
  double sum = 0;
  for (const Harmonic& h : harmonics) sum += h.amplitude * std::cos(angular_frequency(h.frequency) * time + h.phase);
  return sum;
}

// Samples of both directions over their common period; where the phase is unlocked or there is none, over the period of
// each.
Samples samples_of(const HarmonicMotion& motion) {
  constexpr int n_of_oscillation = 1440, most_oscillations = 64;
  Samples samples{{}, {}, motion.phase_locked && common_cycle(motion).has_value()};
  const auto add = [&](std::vector<double>& values, const std::vector<Harmonic>& harmonics, double mean) {
    HarmonicMotion alone{motion.indentation, harmonics, {}, true};
    if (samples.locked) alone = motion;
    const auto cycle = common_cycle(alone);
    if (!cycle) reject("frequencies", harmonics.front().frequency, "must be commensurate within a direction");
    const int n = n_of_oscillation * std::clamp(cycle->highest_order(), 1, most_oscillations);
    for (int i = 0; i < n; ++i) values.push_back(mean + sum_of(harmonics, i / (cycle->frequency * n)));
  };
  add(samples.normal, motion.normal, motion.indentation);
  add(samples.tangential, motion.tangential, 0);
  return samples;
}

// Maximum of a periodic signal: the vertex of the parabola through the largest sample and its two neighbours.
double maximum(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const auto k = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const double before = values[(k + n - 1) % n], here = values[k], after = values[(k + 1) % n];
  const double bend = before - 2 * here + after, slope = (after - before) / 2;
  return bend < 0 ? here - slope * slope / (2 * bend) : here;
}

double sum_of_maxima(const std::vector<double>& first, const std::vector<double>& second, double sign, bool locked) {
  std::vector<double> total(first);
  for (double& value : total) value *= sign;
  if (!locked) return maximum(total) + maximum(second);
  for (std::size_t i = 0; i < total.size(); ++i) total[i] += second[i];
  return maximum(total);
}

class Oscillation {
 public:
  Oscillation(const Profile& profile, const Layer& layer, double shear_modulus, double mu, const Prescribed& prescribed,
              const Samples& samples, double least, double most)
      : profile_(profile),
        layer_(layer),
        family_(profile, layer, least, most),
        by_force_(prescribed.tangential_force),
        locked_(samples.locked) {
    const double modulus = spring_modulus(Direction::normal, layer.poisson_ratio) * shear_modulus;
    const double pull = 1 / (mu * (by_force_ ? 2 * modulus : spring_modulus_ratio(layer.poisson_ratio)));
    for (const double value : samples.tangential) pull_.push_back(pull * value);
    Eigen::ArrayXd normal(family_.radius.size());
    for (Eigen::Index k = 0; k < normal.size(); ++k) {
      const LayerContact& contact = family_.contacts[static_cast<std::size_t>(k)];
      normal[k] = prescribed.normal_force ? normal_force(contact, shear_modulus) : contact.indentation;
    }
    for (const double value : samples.normal) radius_.push_back(radius_of(normal, value, least, most));
  }

  // M+ and M- at a stick radius.
  [[nodiscard]] std::pair<double, double> excesses(double c) const {
    const StickRow row(profile_, layer_, c, family_.radius.maxCoeff());
    Eigen::ArrayXd reach(family_.radius.size());
    for (Eigen::Index k = 0; k < reach.size(); ++k) {
      const SlipReach of_node = slip_reach(row, family_.contacts[static_cast<std::size_t>(k)]);
      reach[k] = by_force_ ? of_node.load : of_node.depth;
    }
    std::vector<double> relief;
    for (const double a : radius_) relief.push_back(-family_.at(reach, a));
    return {sum_of_maxima(pull_, relief, 1, locked_), sum_of_maxima(pull_, relief, -1, locked_)};
  }

  // No node of a family is at the end of its interval.
  [[nodiscard]] double largest_stick_radius() const { return family_.radius.minCoeff(); }

 private:
  [[nodiscard]] double radius_of(const Eigen::ArrayXd& normal, double value, double least, double most) const {
    const auto excess = [&](double a) { return family_.at(normal, a) - value; };
    if (excess(least) >= 0) return least;
    if (excess(most) <= 0) return most;
    std::uintmax_t iterations = 60;
    const auto bracket = boost::math::tools::toms748_solve(excess, least, most,
                                                           boost::math::tools::eps_tolerance<double>(48), iterations);
    return (bracket.first + bracket.second) / 2;
  }

  const Profile& profile_;
  const Layer& layer_;
  ContactFamily family_;
  bool by_force_, locked_;
  std::vector<double> pull_, radius_;  // of the samples: T, and the contact radius
};

std::optional<double> root_of(const std::function<double(double)>& excess, double largest) {
  constexpr double least_share = 1e-6;
  const double least = least_share * largest;
  if (excess(least) >= 0) return std::nullopt;
  if (excess(largest) <= 0) return largest;
  std::uintmax_t iterations = 60;
  const auto bracket = boost::math::tools::toms748_solve(excess, least, largest,
                                                         boost::math::tools::eps_tolerance<double>(40), iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

StickRadii layer_stick_radii(const Profile& profile, const Layer& layer, double shear_modulus, double mu,
                             const Prescribed& prescribed) {
  validate(layer);
  require_positive("shear modulus", shear_modulus);
  require_positive("coefficient of friction", mu);
  validate(prescribed.motion);
  const double least = minimum_indentation(prescribed.motion), most = maximum_indentation(prescribed.motion);
  if (least <= 0) return {};
  const auto radius_at = [&](double value) {
    return prescribed.normal_force ? layer_contact_under_force(profile, layer, shear_modulus, value).contact_radius
                                   : layer_contact_at_depth(profile, layer, value).contact_radius;
  };
  // An interval of some length, also where nothing moves.
  constexpr double room = 1e-3;
  const double smallest = radius_at(least), a = std::max(radius_at(most), smallest * (1 + room));
  const Oscillation oscillation(profile, layer, shear_modulus, mu, prescribed, samples_of(prescribed.motion), smallest,
                                std::min(a, end_radius(profile)));
  const double largest = std::min(smallest, oscillation.largest_stick_radius());
  const auto radius = [&](auto&& of_both) {
    return root_of([&](double c) { return of_both(oscillation.excesses(c)); }, largest);
  };
  return {radius([](const auto& m) { return std::max(m.first, m.second); }),
          radius([](const auto& m) { return m.first + m.second; })};
}

}  // namespace fretval::mdr
