#include "mdr/springs/spring_energy.h"

#include <algorithm>
#include <cmath>

namespace fretval::mdr {

namespace {

// int h^2/(gamma tau) dt over a step in which h decays and the tip moves by `move` at constant rate.
double branch_heat(double gamma, double tau, double dt, const Eigen::ArrayXd& width, const Eigen::ArrayXd& memory,
                   const Eigen::ArrayXd& move) {
  const double z = dt / tau, once = -std::expm1(-z), twice = -std::expm1(-2 * z) / 2;
  const Eigen::ArrayXd steady = gamma / z * move, rest = memory - steady;
  return (width * (twice * rest.square() + 2 * once * rest * steady + z * steady.square())).sum() / gamma;
}

// Stiffness of a stuck spring in a step, over the relaxed one.
double step_stiffness(const PronyBody& body, double dt) {
  double stiffness = 1;
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) stiffness += branch_gain(body, i, dt);
  return stiffness;
}

double stored(const SpringBed& bed, const PronyBody& body, const Eigen::ArrayXd& tip, const Eigen::ArrayXXd& memory) {
  double energy = (bed.width * tip.square()).sum() / 2;
  for (Eigen::Index i = 0; i < memory.cols(); ++i) {
    const double gamma = body.branch_moduli[static_cast<std::size_t>(i)] / body.relaxed_modulus;
    energy += (bed.width * memory.col(i).square()).sum() / (2 * gamma);
  }
  return energy;
}

}  // namespace

double normal_scale(const PronyBody& body) {
  return 2 * 4 * body.relaxed_modulus;
}

double tangential_scale(const PronyBody& body) {
  return 2 * 8.0 / 3 * body.relaxed_modulus;
}

double normal_force(const SpringBed& bed, const PronyBody& body, const SpringState& state) {
  return normal_scale(body) * (bed.width * state.normal_load).sum();
}

Eigen::ArrayXd edge_widths(const SpringBed& bed, const SpringState& state) {
  constexpr Eigen::Index n_to_continue = 3;  // a quadratic
  const auto &x = bed.position, &width = bed.width, &depth = bed.depth;
  const auto& load = state.normal_load;
  const Eigen::Index n = x.size();
  Eigen::ArrayXd at_edge = Eigen::ArrayXd::Zero(n);
  if (n < n_to_continue) return at_edge;
  // Gaps between tips and indenter; beyond the bed those of untouched tips below a quadratic g.
  const auto gap = [&, d = state.indenter.indentation](Eigen::Index j) {
    if (j < n) return state.normal_depth[j] - (d - depth[j]);
    const double bend = depth[n - 1] - 2 * depth[n - 2] + depth[n - 3], beyond = static_cast<double>(j - n + 1);
    return depth[n - 1] + beyond * (depth[n - 1] - depth[n - 2] + (beyond + 1) / 2 * bend) - d;
  };
  const auto is_free = [&](Eigen::Index j) { return j >= n || load[j] == 0; };
  for (Eigen::Index j = 1; j < n; ++j) {
    const double first = gap(j + 1), slope = gap(j + 2) - first;
    if (is_free(j - 1) || is_free(j) || !is_free(j + 1) || !is_free(j + 2) || slope <= 0) continue;
    const double end = x[j] + width[j] / 2, farthest = j + 1 < n ? x[j + 1] : end;
    const double edge = std::clamp(x[j] + width[j] * (1 - first / slope), x[j], farthest);
    const double missing = edge - end, ahead = ((end + edge) / 2 - x[j]) / width[j];  // springs
    if (missing > 0 && load[j] + ahead * (load[j] - load[j - 1]) <= 0) continue;
    at_edge[j] += missing * (1 + ahead);
    at_edge[j - 1] -= missing * ahead;
    if (j + 1 < n) at_edge[j + 1] -= missing;
  }
  return at_edge;
}

HeatWidths widths_in_step(const SpringBed& bed, const PronyBody& body, const SpringState& before,
                          const SpringState& after, const ByForce& by_force) {
  const bool is_elastic = body.viscosity == 0 && body.branch_moduli.empty();  // no heat but friction's
  if (by_force.normal || is_elastic) return {bed.width, bed.width};
  const Eigen::ArrayXd width = bed.width + (edge_widths(bed, before) + edge_widths(bed, after)) / 2;
  return {body.viscosity > 0 ? width : bed.width, width};
}

SpringForces forces_of_springs(const SpringBed& bed, const PronyBody& body, const Eigen::ArrayXd& weights,
                               const SpringState& state, const ByForce& by_force) {
  SpringForces forces{normal_force(bed, body, state), tangential_force(bed, body, state),
                      axis_pressure(weights, body, state)};
  if (by_force.normal) return forces;
  const Eigen::ArrayXd at_edge = edge_widths(bed, state);
  forces.normal += normal_scale(body) * (at_edge * state.normal_load).sum();
  if (!by_force.tangential) forces.tangential += tangential_scale(body) * (at_edge * state.tangential_load).sum();
  return forces;
}

double tangential_force(const SpringBed& bed, const PronyBody& body, const SpringState& state) {
  return tangential_scale(body) * (bed.width * state.tangential_load).sum();
}

double axis_pressure(const Eigen::ArrayXd& weights, const PronyBody& body, const SpringState& state) {
  return 4 * body.relaxed_modulus * (weights * state.normal_load).sum();
}

double stored_energy(const SpringBed& bed, const PronyBody& body, const SpringState& state) {
  return normal_scale(body) * stored(bed, body, state.normal_depth, state.normal_memory) +
         tangential_scale(body) * stored(bed, body, state.tangential_shift, state.tangential_memory);
}

double bulk_heat(const Eigen::ArrayXd& width, const PronyBody& body, double dt, const Eigen::ArrayXXd& memory,
                 const Eigen::ArrayXd& move) {
  double heat = body.viscosity / (body.relaxed_modulus * dt) * (width * move.square()).sum();
  for (Eigen::Index i = 0; i < memory.cols(); ++i) {
    const auto branch = static_cast<std::size_t>(i);
    heat += branch_heat(body.branch_moduli[branch] / body.relaxed_modulus, body.branch_times[branch], dt, width,
                        memory.col(i), move);
  }
  return heat;
}

double friction_heat(const Eigen::ArrayXd& width, const PronyBody& body, double friction_limit, double dt,
                     const SpringState& before, const SpringState& after) {
  const Eigen::ArrayXd& path = after.slip;
  const Eigen::ArrayXd limit = friction_limit * before.normal_load, limit_after = friction_limit * after.normal_load;
  // Traction in the direction of slip; the stuck spring would have gone beyond the limit by its stiffness times slip.
  const Eigen::ArrayXd room = (limit - path.sign() * before.tangential_load).max(0);
  const Eigen::ArrayXd beyond = step_stiffness(body, dt) * path.abs();
  const Eigen::ArrayXd sum = (room + beyond > 0).select(room + beyond, 1.0);
  const Eigen::ArrayXd onset = (limit * beyond + limit_after * room) / sum;
  return (width * path.abs() * (onset + limit_after) / 2).sum();
}

Dissipation dissipation(const HeatWidths& width, const PronyBody& body, double mu, double dt, const SpringState& before,
                        const SpringState& after) {
  return {tangential_scale(body) * friction_heat(width.friction, body, 1.5 * mu, dt, before, after),
          normal_scale(body) *
                  bulk_heat(width.bulk, body, dt, before.normal_memory, after.normal_depth - before.normal_depth) +
              tangential_scale(body) * bulk_heat(width.bulk, body, dt, before.tangential_memory,
                                                 after.tangential_shift - before.tangential_shift)};
}

}  // namespace fretval::mdr
