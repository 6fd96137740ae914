#include "mdr/wear/wear_cycle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <stdexcept>
#include <string>

#include "mdr/springs/spring_energy.h"

namespace fretval::mdr {

namespace {
constexpr int n_ramp_cycles = 3;
constexpr int most_settling_cycles = 20000;
constexpr int longest_period = 12;     // in cycles: dashpots that lose and regain contact may repeat in several only
constexpr double settled = 1e-8;       // change of the tractions in a cycle, over the largest
constexpr double hardly_slips = 1e-6;  // slip in a cycle, over the tangential amplitude
constexpr double touching = 1e-6;      // gap, over the indentation: worn surfaces that only just part still touch
}  // namespace

WearingSprings::WearingSprings(const SpringBed& bed, const PronyBody& body, double mu, const Motion& motion,
                               int steps_per_cycle)
    : body_(body),
      mu_(mu),
      motion_(motion),
      steps_per_cycle_(steps_per_cycle),
      dt_(1 / motion.normal_frequency / steps_per_cycle),
      path_(ramped_path(harmonic_motion(motion), n_ramp_cycles / motion.normal_frequency)),
      bed_(bed),
      step_(body, mu, dt_),
      state_(relaxed_state(bed, body, motion.indentation)) {
  for (; n_cycles_ < n_ramp_cycles; ++n_cycles_)
    for (int k = 1; k <= steps_per_cycle_; ++k) step(k);
}

void WearingSprings::set_depth(const Eigen::ArrayXd& depth) {
  bed_.depth = depth;
}

void WearingSprings::step(int k) {
  const double time = (n_cycles_ + static_cast<double>(k) / steps_per_cycle_) / motion_.normal_frequency;
  step_.advance(state_, bed_, path_(time));
}

int WearingSprings::settle() {
  std::deque<Eigen::ArrayXd> latest{state_.tangential_load};  // at the ends of cycles, the last one first
  for (int cycle = 0; cycle < most_settling_cycles; ++cycle) {
    for (int k = 1; k <= steps_per_cycle_; ++k) step(k);
    ++n_cycles_;
    const double allowed = settled * mu_ * state_.normal_load.maxCoeff();
    for (std::size_t period = 1; period <= latest.size(); ++period)
      if ((state_.tangential_load - latest[period - 1]).abs().maxCoeff() <= allowed) return static_cast<int>(period);
    latest.push_front(state_.tangential_load);
    if (latest.size() > longest_period) latest.pop_back();
  }
  throw std::runtime_error("tractions of the springs still change after " + std::to_string(most_settling_cycles) +
                           " cycles on the same profile: a relaxation time is far longer than the period");
}

WearCycle WearingSprings::settled_cycle(const AbelMatrices& matrices) {
  const int period = settle();
  const Eigen::Index n = bed_.depth.size(), n_instants = static_cast<Eigen::Index>(period) * steps_per_cycle_;
  Eigen::MatrixXd slip(n, n_instants);
  WearCycle cycle{{}, Eigen::MatrixXd(n, n_instants), 0, 0, 0};
  for (Eigen::Index instant = 0; instant < n_instants; ++instant) {
    const SpringState before = state_;
    step(static_cast<int>(instant) + 1);
    slip.col(instant) = slip_in_contact(before).matrix();
    const Eigen::ArrayXd gap = state_.normal_depth - (state_.indenter.indentation - bed_.depth);
    cycle.load.col(instant) = (state_.normal_load > 0).select(state_.normal_load, -gap.max(0)).matrix();
    cycle.friction_work += dissipation({bed_.width, bed_.width}, body_, mu_, dt_, before, state_).friction / period;
  }
  n_cycles_ += period;
  const Eigen::ArrayXd spring_path = slip.cwiseAbs().rowwise().sum() / period;
  for (Eigen::Index j = 0; j < n; ++j)
    if (spring_path[j] <= hardly_slips * motion_.tangential_amplitude) slip.row(j).setZero();
  const Eigen::MatrixXd path = (matrices.displacement.triangularView<Eigen::Lower>() * slip).cwiseAbs() / (2 * period);
  cycle.path = path;
  cycle.path.leftCols(n_instants - 1) += path.rightCols(n_instants - 1);
  cycle.path.col(n_instants - 1) += path.col(0);
  find_radii(cycle, slip);
  return cycle;
}

// Slip of each spring against the indenter in the last step, m. A spring that touches in the step slips from then on. A
// spring that sticks at the beginning of the step in which it leaves the contact is taken to stick until it does, as
// load and traction die out together. For springs that stay open it is the motion of the indenter past their tips: they
// take no part in the contact, but enter the slip of the surface outside them.
Eigen::ArrayXd WearingSprings::slip_in_contact(const SpringState& before) const {
  const double shift = state_.indenter.tangential - before.indenter.tangential;
  const Eigen::ArrayXd open = shift - (state_.tangential_shift - before.tangential_shift);
  const auto leaves = before.normal_load > 0 && state_.normal_load == 0;
  const Eigen::ArrayXd slip = (leaves && before.slip == 0).select(0, state_.slip);
  return (before.normal_load.max(state_.normal_load) > 0).select(slip, open);
}

void WearingSprings::find_radii(WearCycle& cycle, const Eigen::MatrixXd& slip) const {
  const auto outer_edge = [&](Eigen::Index j) { return j < 0 ? 0 : bed_.position[j] + bed_.width[j] / 2; };
  const double touch = -touching * motion_.indentation;
  Eigen::Index outermost = slip.rows() - 1, sticking = 0;
  while (outermost >= 0 && cycle.load.row(outermost).maxCoeff() < touch) --outermost;
  while (sticking < slip.rows() && slip.row(sticking).isZero(0)) ++sticking;
  cycle.contact_radius = outer_edge(outermost);
  cycle.stick_radius = outer_edge(std::min(sticking - 1, outermost));
}

}  // namespace fretval::mdr
