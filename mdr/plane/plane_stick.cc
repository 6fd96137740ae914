#include "mdr/plane/plane_stick.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {
namespace {

/// Sum of the harmonics that go across, or of the others, as a stuck element responds to them, at instants of a cycle.
Eigen::ArrayXd response(const Rheology& body, const std::vector<Harmonic>& harmonics, const std::vector<int>& orders,
                        bool across, int n_instants) {
  const Eigen::ArrayXd angle = Eigen::ArrayXd::LinSpaced(n_instants + 1, 0, 2 * pi).head(n_instants);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(n_instants);
  for (std::size_t k = 0; k < harmonics.size(); ++k) {
    const auto& harmonic = harmonics[k];
    if (harmonic.across != across || harmonic.amplitude == 0) continue;
    const auto modulus = complex_modulus_ratio(body, angular_frequency(harmonic.frequency));
    sum += harmonic.amplitude * std::abs(modulus) * (orders[k] * angle + harmonic.phase + std::arg(modulus)).cos();
  }
  return sum;
}

/// Least value of a convex function on an interval, by golden sections.
double least_of_convex(const std::function<double(double)>& f, double from, double to) {
  constexpr double golden = 0.6180339887498949;
  constexpr int n_sections = 60;  // to 3e-13 of the interval
  double a = to - golden * (to - from), b = from + golden * (to - from), at_a = f(a), at_b = f(b);
  for (int i = 0; i < n_sections; ++i) {
    if (at_a < at_b) {
      to = b;
      b = a;
      at_b = at_a;
      at_a = f(a = to - golden * (to - from));
    } else {
      from = a;
      a = b;
      at_a = at_b;
      at_b = f(b = from + golden * (to - from));
    }
  }
  return std::min(at_a, at_b);
}

/// The instants that can bind: where N is so large that no offset within the range of T makes it the least, it is
/// left out.
StuckElement binding(const StuckElement& all, double range) {
  const double least = all.normal.minCoeff();
  StuckElement some{Eigen::ArrayXd(all.x.size()), Eigen::ArrayXd(all.x.size()), Eigen::ArrayXd(all.x.size())};
  Eigen::Index n = 0;
  for (Eigen::Index k = 0; k < all.x.size(); ++k) {
    if (all.normal[k] > least + 2 * range) continue;
    some.x[n] = all.x[k];
    some.y[n] = all.y[k];
    some.normal[n++] = all.normal[k];
  }
  for (auto* part : {&some.x, &some.y, &some.normal}) part->conservativeResize(n);
  return some;
}

double shakedown_of(const StuckElement& all) {
  const double x0 = all.x.minCoeff(), x1 = all.x.maxCoeff(), y0 = all.y.minCoeff(), y1 = all.y.maxCoeff();
  const auto element = binding(all, std::hypot(x1 - x0, y1 - y0));
  const auto lack = [&](double ox, double oy) {
    return (((element.x - ox).square() + (element.y - oy).square()).sqrt() - element.normal).maxCoeff();
  };
  const auto least_along_y = [&](double ox) {
    return least_of_convex([&](double oy) { return lack(ox, oy); }, y0, y1);
  };
  return -least_of_convex(least_along_y, x0, x1);
}

}  // namespace

StuckElement stuck_element(const Rheology& body, double mu, const HarmonicMotion& motion, int n_instants) {
  validate(motion);
  require_positive("coefficient of friction", mu);
  const auto cycle = common_cycle(motion);
  if (!cycle || !motion.phase_locked)
    throw std::invalid_argument("a motion in two directions needs a common cycle and a fixed phase");
  const double scale = 2 / (3 * mu);
  return {scale * response(body, motion.tangential, cycle->tangential_orders, false, n_instants),
          scale * response(body, motion.tangential, cycle->tangential_orders, true, n_instants),
          motion.indentation + response(body, motion.normal, cycle->normal_orders, false, n_instants)};
}

StuckElement stuck_element(const PronyBody& body, double mu, const SampledPath& path, int n_per_piece) {
  require_positive("coefficient of friction", mu);
  auto turned = path;
  turned.tangential = path.transverse;
  const auto x = path_response(body, path, PathDirection::tangential),
             y = path_response(body, turned, PathDirection::tangential),
             normal = path_response(body, path, PathDirection::normal);
  const auto n_instants = static_cast<Eigen::Index>(path.n_pieces()) * (n_per_piece + 1);
  StuckElement element{Eigen::ArrayXd(n_instants), Eigen::ArrayXd(n_instants), Eigen::ArrayXd(n_instants)};
  const double scale = 2 / (3 * mu);
  Eigen::Index k = 0;
  for (std::size_t piece = 0; piece < path.n_pieces(); ++piece)
    for (int j = 0; j <= n_per_piece; ++j, ++k) {
      const double s = (path.time[piece + 1] - path.time[piece]) * j / n_per_piece;
      element.x[k] = scale * x[piece](s);
      element.y[k] = scale * y[piece](s);
      element.normal[k] = normal[piece](s);
    }
  return element;
}

StickDepths plane_stick_depths(const StuckElement& element) {
  const double first_slip = (element.normal - (element.x.square() + element.y.square()).sqrt()).minCoeff();
  return {first_slip, std::max(first_slip, shakedown_of(element))};
}

StickDepths plane_stick_depths(const Rheology& body, double mu, const HarmonicMotion& motion) {
  const auto cycle = common_cycle(motion);
  if (!cycle) throw std::invalid_argument("the motion has no common cycle");
  return plane_stick_depths(stuck_element(body, mu, motion, instants_per_oscillation * cycle->highest_order()));
}

}  // namespace fretval::mdr
