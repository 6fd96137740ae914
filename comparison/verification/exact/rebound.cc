#include "comparison/verification/exact/rebound.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace fretval {
namespace {

/// Displacement, velocity, and per branch the memories of the displacement and of the elastic force:
/// `int G_i exp(-(t - t')/tau_i) dd` and the same of dF_el.
using State = Eigen::VectorXd;

class Sphere {
 public:
  Sphere(const mdr::PronyBody& body, const Impact& impact)
      : body_(body), impact_(impact), n_(static_cast<Eigen::Index>(body.branch_times.size())) {}

  Rebound rebound(int n_steps) {
    go_in(n_steps);
    return go_out(n_steps);
  }

 private:
  static double elastic_force(double d) { return 16.0 / 3 * d * std::sqrt(std::max(0.0, d)); }

  [[nodiscard]] double modulus(Eigen::Index i) const { return body_.branch_moduli[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double decay(Eigen::Index i, double t) const {
    return std::exp(-t / body_.branch_times[static_cast<std::size_t>(i)]);
  }

  [[nodiscard]] double force_growing(const State& y) const {
    return body_.relaxed_modulus * elastic_force(y[0]) + y.tail(n_).sum();
  }

  /// Rates under a force. On the way out nobody asks for the memory of the elastic force.
  [[nodiscard]] State rates(const State& y, double force) const {
    State rate(y.size());
    rate[0] = y[1];
    rate[1] = -force / impact_.mass;
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double tau = body_.branch_times[static_cast<std::size_t>(i)];
      rate[2 + i] = modulus(i) * y[1] - y[2 + i] / tau;
      rate[2 + n_ + i] = modulus(i) * 8 * std::sqrt(std::max(0.0, y[0])) * y[1] - y[2 + n_ + i] / tau;
    }
    return rate;
  }

  /// One step of classical Runge-Kutta; rate: of the independent variable and the state.
  template <typename Rate>
  static State stepped(double x, const State& y, double dx, const Rate& rate) {
    const State k1 = rate(x, y), k2 = rate(x + dx / 2, y + dx / 2 * k1);
    const State k3 = rate(x + dx / 2, y + dx / 2 * k2), k4 = rate(x + dx, y + dx * k3);
    return y + dx / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }

  /// Per root of time: all is smooth in it, while the force begins like t^(3/2).
  [[nodiscard]] State rates_growing(double root, const State& y) const { return 2 * root * rates(y, force_growing(y)); }

  /// Up to the largest indentation, in equal steps of the root of time but for the last one.
  void go_in(int n_steps) {
    const auto rate = [this](double root, const State& y) { return rates_growing(root, y); };
    State y = State::Zero(2 + 2 * n_);
    y[1] = impact_.velocity;
    const double kinetic = impact_.mass * impact_.velocity * impact_.velocity / 2;
    const double relaxed_depth = std::pow(kinetic / body_.relaxed_modulus * 15 / 32, 0.4);
    const double step = std::sqrt(1.5 * relaxed_depth / impact_.velocity) / n_steps;
    double root = 0;
    keep(root, y);
    for (State next = stepped(root, y, step, rate); next[1] > 0; next = stepped(root, y, step, rate))
      keep(root += step, y = next);
    const auto velocity = [&](double dx) { return stepped(root, y, dx, rate)[1]; };
    const auto bracket = boost::math::tools::bisect(velocity, 0.0, step, boost::math::tools::eps_tolerance<double>(48));
    keep(root + bracket.second, stepped(root, y, bracket.second, rate));
  }

  void keep(double root, const State& y) {
    root_.push_back(root);
    way_in_.push_back(y);
    rate_.push_back(rates_growing(root, y));
  }

  [[nodiscard]] State way_in(double root) const {
    const auto after = std::upper_bound(root_.begin() + 1, root_.end() - 1, root);
    const auto k = static_cast<std::size_t>(after - root_.begin());
    const double step = root_[k] - root_[k - 1], x = (root - root_[k - 1]) / step;
    return (1 + 2 * x) * (1 - x) * (1 - x) * way_in_[k - 1] + x * x * (3 - 2 * x) * way_in_[k] +
           step * x * (1 - x) * ((1 - x) * rate_[k - 1] - x * rate_[k]);
  }

  [[nodiscard]] double largest_force() const {
    const auto pull = [this](double root) { return -force_growing(way_in(root)); };
    // The force has one maximum; half of its digits for the place are all of them for the value.
    return -boost::math::tools::brent_find_minima(pull, 0.0, root_.back(), 26).second;
  }

  /// Load, at the instant t of the way out, of a point that the contact reached at the instant `touched`.
  [[nodiscard]] double load(double t, const State& y, double touched) const {
    const State then = way_in(std::sqrt(touched));
    double load = body_.relaxed_modulus * (y[0] - then[0]);
    for (Eigen::Index i = 0; i < n_; ++i) load += y[2 + i] - decay(i, t - touched) * then[2 + i];
    return load;
  }

  [[nodiscard]] double force_shrinking(double t, const State& y) const {
    const auto load_of = [&](double touched) { return load(t, y, touched); };
    if (load_of(0) <= 0) return 0;
    double touched = deepest();
    if (load_of(touched) < 0) {
      const auto bracket =
          boost::math::tools::bisect(load_of, 0.0, touched, boost::math::tools::eps_tolerance<double>(48));
      touched = (bracket.first + bracket.second) / 2;
    }
    const State then = way_in(std::sqrt(touched));
    double force = body_.relaxed_modulus * elastic_force(then[0]);
    for (Eigen::Index i = 0; i < n_; ++i) force += decay(i, t - touched) * then[2 + n_ + i];
    return force;
  }

  /// Instant of the largest indentation.
  [[nodiscard]] double deepest() const { return root_.back() * root_.back(); }

  Rebound go_out(int n_steps) {
    const auto rate = [this](double t, const State& y) { return rates(y, force_shrinking(t, y)); };
    State y = way_in_.back();
    const double step = deepest() / n_steps;
    double t = deepest();
    for (State next = stepped(t, y, step, rate); load(t + step, next, 0) > 0; next = stepped(t, y, step, rate)) {
      y = next;
      t += step;
    }
    const auto last_load = [&](double dt) { return load(t + dt, stepped(t, y, dt, rate), 0); };
    const auto bracket =
        boost::math::tools::bisect(last_load, 0.0, step, boost::math::tools::eps_tolerance<double>(48));
    y = stepped(t, y, bracket.second, rate);
    return {-y[1] / impact_.velocity, largest_force(), t + bracket.second};
  }

  const mdr::PronyBody& body_;
  Impact impact_;
  Eigen::Index n_;
  std::vector<double> root_;  // of the instants of the way in
  std::vector<State> way_in_, rate_;
};

}  // namespace

Rebound exact_rebound(const mdr::PronyBody& body, const Impact& impact, int n_steps) {
  mdr::validate(body);
  if (body.viscosity > 0) throw std::invalid_argument("rebound from a body with a dashpot: not covered");
  if (!(impact.mass > 0 && impact.velocity > 0))
    throw std::invalid_argument("mass and velocity of an impact must be positive");
  return Sphere(body, impact).rebound(n_steps);
}

}  // namespace fretval
