#include "mdr/layer/coupled_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mdr/layer/coupled_step.h"
#include "mdr/springs/stepped_history.h"

namespace fretval::mdr {

namespace {

// The quadratic form f -> f (1 + coupling)^-1 f as weights of the springs and, after them, of the modes.
struct QuadraticForm {
  Eigen::ArrayXd weight;
  Eigen::MatrixXd to_modes;

  QuadraticForm(const SpringBed& bed, const LayerModes& modes)
      : weight(bed.width.size() + modes.strength.size()), to_modes(modes.shape.transpose()) {
    weight << bed.width, -bed.width[0] * modes.strength / (1 + modes.strength);
  }

  [[nodiscard]] Eigen::ArrayXXd variables(const Eigen::ArrayXXd& of_springs) const {
    Eigen::ArrayXXd all(weight.size(), of_springs.cols());
    all << of_springs, (to_modes * of_springs.matrix()).array();
    return all;
  }
};

double bulk_heat(const SpringBed& bed, const LayerModes& modes, const PronyBody& body, double dt,
                 const Eigen::ArrayXXd& memory, const Eigen::ArrayXd& move) {
  const QuadraticForm form(bed, modes);
  return mdr::bulk_heat(form.weight, body, dt, form.variables(memory), form.variables(move));
}

// Widths by which the tractions of springs carry on over the rim, m: what the rim bears over what the springs next to
// it do. A spring whose middle is not in contact has its rim from the one inside it.
Eigen::ArrayXd rim_widths(const SpringBed& bed, const SpringState& state) {
  const Eigen::ArrayXd &load = state.normal_load, &rim = state.rim_load;
  Eigen::ArrayXd widths = Eigen::ArrayXd::Zero(load.size());
  for (Eigen::Index j = 0; j < rim.size(); ++j) {
    const Eigen::Index bears = load[j] > 0 ? j : j - 1;
    if (rim[j] > 0 && bears >= 0 && load[bears] > 0) widths[bears] += bed.width[j] * rim[j] / load[bears];
  }
  return widths;
}

class CoupledSprings {
 public:
  CoupledSprings(const CoupledBed& bed, const PronyBody& body, double mu, const Loading& loading,
                 const HistoryControl& control)
      : bed_(bed),
        body_(body),
        mu_(mu),
        loading_(loading),
        dt_(control.period / control.steps_per_period),
        step_(bed, body, mu, dt_),
        axis_weights_(axis_weights(bed.springs)),
        normal_scale_(force_scale(bed, body, Direction::normal)),
        tangential_scale_(force_scale(bed, body, Direction::tangential)) {}

  [[nodiscard]] SpringState start() const {
    return relaxed_state(bed_, body_,
                         loading_.normal_force ? relaxed_indentation(bed_, loading_.normal_force(0) / normal_scale_)
                                               : loading_.path(0).indentation);
  }

  void advance(SpringState& state, double time) const {
    PrescribedInStep prescribed{loading_.path ? loading_.path(time) : state.indenter, {}, {}};
    if (loading_.normal_force) prescribed.normal_load = loading_.normal_force(time) / normal_scale_;
    if (loading_.tangential_force) prescribed.tangential_load = loading_.tangential_force(time) / tangential_scale_;
    step_.advance(state, prescribed);
  }

  [[nodiscard]] double friction_limit() const { return mu_ * spring_modulus_ratio(bed_.layer.poisson_ratio); }

  [[nodiscard]] SpringForces forces(const SpringState& state) const {
    return coupled_forces(bed_, body_, axis_weights_, state,
                          {static_cast<bool>(loading_.normal_force), static_cast<bool>(loading_.tangential_force)});
  }

  [[nodiscard]] Dissipation heat(const SpringState& before, const SpringState& after) const {
    return dissipation(bed_, body_, mu_, dt_, before, after);
  }

  [[nodiscard]] double stick_depth(const Eigen::ArrayXd& margin, const SlipOfSprings& slip) const {
    return coupled_stick_depth(bed_.springs, friction_limit(), margin, slip.path[0] / slip.n_ways);
  }

 private:
  const CoupledBed& bed_;
  const PronyBody& body_;
  double mu_;
  const Loading& loading_;
  double dt_;
  CoupledStep step_;
  Eigen::ArrayXd axis_weights_;
  double normal_scale_, tangential_scale_;  // N per sum(width * load)
};

}  // namespace

double force_scale(const CoupledBed& bed, const PronyBody& body, Direction direction) {
  return 2 * spring_modulus(direction, bed.layer.poisson_ratio) * body.relaxed_modulus;
}

SpringForces coupled_forces(const CoupledBed& bed, const PronyBody& body, const Eigen::ArrayXd& weights,
                            const SpringState& state, const ByForce& by_force) {
  const SpringBed& springs = bed.springs;
  const double of_half_space = force_scale(bed, body, Direction::normal) / normal_scale(body);
  // Without a dashpot rim loads are what the edge bears.
  const auto whole = body.viscosity > 0 ? by_force : ByForce{true, true};
  const auto forces = forces_of_springs(springs, body, weights, state, whole);
  const double at_rim = normal_scale(body) * (springs.width * state.rim_load).sum();
  double tangential = forces.tangential;
  if (!by_force.tangential)
    tangential += tangential_scale(body) * (rim_widths(springs, state) * state.tangential_load).sum();
  return {of_half_space * (forces.normal + at_rim),
          force_scale(bed, body, Direction::tangential) / tangential_scale(body) * tangential,
          of_half_space * forces.axis_pressure};
}

Dissipation dissipation(const CoupledBed& bed, const PronyBody& body, double mu, double dt, const SpringState& before,
                        const SpringState& after) {
  const double limit = mu * spring_modulus_ratio(bed.layer.poisson_ratio);
  const double normal = force_scale(bed, body, Direction::normal),
               tangential = force_scale(bed, body, Direction::tangential);
  return {tangential * friction_heat(bed.springs.width, body, limit, dt, before, after),
          normal * bulk_heat(bed.springs, bed.normal, body, dt, before.normal_memory,
                             after.normal_depth - before.normal_depth) +
              tangential * bulk_heat(bed.springs, bed.tangential, body, dt, before.tangential_memory,
                                     after.tangential_shift - before.tangential_shift)};
}

double coupled_stick_depth(const SpringBed& bed, double friction_limit, const Eigen::ArrayXd& margin,
                           double slip_of_innermost) {
  constexpr Eigen::Index n_of_parabola = 3;
  constexpr double roundoff = 1e-12;
  const Eigen::ArrayXd& depth = bed.zone_depth;
  const double none = roundoff * margin.abs().maxCoeff();
  Eigen::Index n = 0;
  while (n < margin.size() && margin[n] > none) ++n;
  if (n == 0) return depth[0] - slip_of_innermost / friction_limit;
  // The next spring does not stick, and the edge of a flat face is a corner, across which nothing is read.
  const bool in_flat_face = depth[n - 1] < 0;
  double farthest = n < margin.size() ? depth[n] : std::numeric_limits<double>::infinity();
  if (in_flat_face) farthest = std::min(farthest, 0.0);
  const auto within = [&](double read) { return std::clamp(read, depth[n - 1], farthest); };
  // In a flat face margins are nearly the same everywhere, so that they tell no depth: all of it sticks that does at
  // its edge.
  if (in_flat_face && farthest == 0) {
    const double rise = n > 1 ? (margin[n - 1] - margin[n - 2]) / (depth[n - 1] - depth[n - 2]) : 0;
    if (margin[n - 1] - rise * depth[n - 1] > 0) return 0;
  }
  if (n < n_of_parabola || (depth[n - 3] < 0) != in_flat_face)
    return within(depth[n - 1] + margin[n - 1] / friction_limit);
  const double m0 = margin[n - 3], m1 = margin[n - 2], m2 = margin[n - 1];
  const double g0 = depth[n - 3], g1 = depth[n - 2], g2 = depth[n - 1];
  // Newton's form at margin 0.
  const double slope = (g2 - g1) / (m2 - m1), bend = (slope - (g1 - g0) / (m1 - m0)) / (m2 - m0);
  return within(g2 - m2 * slope + m2 * m1 * bend);
}

SpringHistory coupled_history(const CoupledBed& bed, const PronyBody& body, double mu, const Loading& loading,
                              const HistoryControl& control) {
  validate(control);
  validate(loading);
  const CoupledSprings springs(bed, body, mu, loading, control);
  return SteppedHistory<CoupledSprings>(springs, body, mu, control).run();
}

}  // namespace fretval::mdr
