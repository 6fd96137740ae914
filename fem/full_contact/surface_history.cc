#include "fem/full_contact/surface_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/full_contact/fields.h"
#include "fem/full_contact/projected_gradients.h"
#include "fem/full_contact/slip_room.h"
#include "fem/history/drive_to_period.h"
#include "fem/support/constants.h"

namespace fretval::fem {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double at_its_limit = 1e-9;  // of the largest one; friction is solved to 1e-11 of it

double change_between(const std::vector<MatrixXd>& now, const std::vector<MatrixXd>& before) {
  double change = 0, largest = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    largest = std::max(largest, now[k].lpNorm<Eigen::Infinity>());
    if (k < before.size()) change = std::max(change, (now[k] - before[k]).lpNorm<Eigen::Infinity>());
  }
  if (before.empty()) return 1;
  return largest > 0 ? change / largest : 0;
}

/// Traction of each ring of the relaxed body by a unit slip of that ring alone, A_i (C^-1)_ii.
VectorXd stiffness_of_rings(const ContactProblem& rings) {
  const MatrixXd inverse_factor = rings.solver.inverse()->triangularView<Eigen::Lower>();
  return rings.compliance.areas.cwiseProduct(inverse_factor.colwise().squaredNorm().transpose());
}

}  // namespace

RingProblems ring_problems(const SurfaceCompliance& surface) {
  return {ContactProblem(ring_compliance(surface, axisymmetric)), ContactProblem(ring_compliance(surface, lateral))};
}

SurfaceWatch::SurfaceWatch(const RingProblems& rings, const AngularGrid& grid, int steps_per_cycle)
    : rings_(rings),
      grid_(grid),
      steps_per_cycle_(steps_per_cycle),
      reserve_(rings.normal.n_rings() * grid.n_kept(), -infinity),
      ever_(Eigen::ArrayXXd::Zero(rings.normal.n_rings(), grid.n_kept())),
      in_cycle_(ever_),
      traction_per_slip_(stiffness_of_rings(rings.tangential)) {}

void SurfaceWatch::begin_cycle() {
  in_cycle_.setZero();
  net_in_cycle_ = MatrixXd::Zero(in_cycle_.rows(), 2 * in_cycle_.cols());
  traction_before_ = std::exchange(traction_, {});
  pressure_.clear();
  limit_.clear();
  forces_.resize(3, steps_per_cycle_);
  displacement_.resize(2, steps_per_cycle_);
  normal_force_.resize(steps_per_cycle_);
  depth_.resize(0);
  pieces_.clear();
  tangential_work_ = normal_work_ = 0;
  dissipated_.push_back(0);
}

void SurfaceWatch::see(const VectorFriction& friction, const MatrixXd& pressure) {
  see_step(friction, pressure, 0);
}

void SurfaceWatch::see(const CoupledContact& contact, double gone_down) {
  see_step(contact.friction, contact.pressure, gone_down);
  const Index k = (n_steps_ - 1) % steps_per_cycle_;
  if (k == 0) depth_.resize(steps_per_cycle_);
  depth_[k] = contact.depth;
}

/// The work in a step is made by the forces in its middle, interpolated between the balance times of this step and the
/// one before.
void SurfaceWatch::see_step(const VectorFriction& friction, const MatrixXd& pressure, double gone_down) {
  if (n_steps_ % steps_per_cycle_ == 0) begin_cycle();
  const MatrixXd margin = (friction.limit - lengths(friction.traction)).cwiseMax(0);
  const Eigen::ArrayXXd slips = (margin.array() <= at_its_limit * friction.limit.maxCoeff()).cast<double>();
  ever_ = ever_.max(slips);
  in_cycle_ += (friction.limit.array() > 0).select(lengths(friction.slip), infinity);
  net_in_cycle_ += friction.slip;
  instantaneous_ = friction.instantaneous();
  const MatrixXd reserve = rings_.tangential.series.depths_of_instants((slips > 0).select(0, margin));
  reserve_.add(Eigen::Map<const VectorXd>(reserve.data(), reserve.size()), friction.in_piece());
  pressure_.push_back(pressure);
  traction_.push_back(friction.traction);
  limit_.push_back(friction.limit);
  const Index k = n_steps_ % steps_per_cycle_;
  forces_.col(k) = friction.forces();
  displacement_.col(k) = friction.displacement;
  normal_force_[k] = (friction.op().areas().transpose() * pressure).sum();
  if (const auto piece = friction.in_piece()) pieces_.push_back(*piece);
  dissipated_.back() += friction.friction_work();
  const Eigen::Vector3d now{forces_(0, k), forces_(1, k), normal_force_[k]};
  if (n_steps_ == 0) before_[2] = now[2];
  const Eigen::Vector3d middle = (1.5 - friction.fraction()) * now + (friction.fraction() - 0.5) * before_;
  tangential_work_ += middle.head<2>().dot(friction.increment);
  normal_work_ += middle[2] * gone_down;
  before_ = now;
  ++n_steps_;
}

SurfaceWatch::Course SurfaceWatch::course_of(Index ring, Index angle) const {
  const Index m = in_cycle_.cols();
  const auto n = static_cast<Index>(traction_.size());
  Course course{VectorXd(n), VectorXd(n), VectorXd(n), 0};
  for (Index k = 0; k < n; ++k) {
    const auto step = static_cast<std::size_t>(k);
    course.x[k] = traction_[step](ring, angle);
    course.y[k] = traction_[step](ring, m + angle);
    course.limit[k] = limit_[step](ring, angle);
    if (traction_before_.empty()) continue;
    const auto& before = traction_before_[step];
    course.change =
        std::max(course.change, std::hypot(course.x[k] - before(ring, angle), course.y[k] - before(ring, m + angle)));
  }
  return course;
}

MatrixXd SurfaceWatch::room() const {
  MatrixXd room = MatrixXd::Zero(in_cycle_.rows(), in_cycle_.cols());
  const MatrixXd to_and_fro = in_cycle_ - lengths(net_in_cycle_);
  for (Index j = 0; j < room.cols(); ++j)
    for (Index i = 0; i < room.rows() && in_cycle_(i, j) < infinity; ++i) {
      const auto course = course_of(i, j);
      const double of_point = slip_room(course.x, course.y, course.limit);
      if (of_point <= course.change + instantaneous_ * traction_per_slip_[i] * to_and_fro(i, j)) break;
      room(i, j) = of_point;
    }
  return room;
}

SurfaceHistory SurfaceWatch::report() const {
  SurfaceHistory history;
  if (n_steps_ < steps_per_cycle_) return history;
  history.n_cycles = static_cast<int>(n_steps_ / steps_per_cycle_);
  const Eigen::Map<const MatrixXd> reserve(reserve_.value().data(), ever_.rows(), ever_.cols());
  history.never_slipped = region_of(rings_.tangential, grid_, reserve, rings_inside(1 - ever_));
  history.sticks_in_a_cycle =
      history.n_cycles == 1 ? history.never_slipped : region_of(rings_.tangential, grid_, room());
  const MatrixXd margin = limit_.back() - lengths(traction_.back());
  const Eigen::ArrayXXd sticks = (margin.array() > at_its_limit * limit_.back().maxCoeff()).cast<double>();
  history.sticks_at_the_end = region_to_a_ring(rings_.tangential.compliance.radii, grid_, rings_inside(sticks));
  MatrixXd largest = pressure_.front();
  for (const auto& pressure : pressure_) largest = largest.cwiseMax(pressure);
  history.contact = region_of(rings_.normal, grid_, largest);
  history.dissipated = dissipated_;
  history.tangential_work = tangential_work_;
  history.normal_work = normal_work_;
  history.forces = forces_;
  history.displacement = displacement_;
  history.depth = depth_;
  history.normal_force = normal_force_;
  history.pieces = pieces_;
  history.pressure = pressure_;
  history.traction = traction_;
  history.periodicity = periodicity();
  return history;
}

double SurfaceWatch::periodicity() const {
  return change_between(traction_, traction_before_);
}

namespace {

/// The way of a contact on rings and angles to its periodic state, see drive_to_period.
struct SurfaceWay : PlainWay {
  const SurfaceWatch& watch;
  const SurfaceControl& control;
  std::function<void()> step_through_cycle;
  int n_cycles = 0;

  SurfaceWay(const SurfaceWatch& watched, const SurfaceControl& controlled, std::function<void()> step)
      : watch(watched), control(controlled), step_through_cycle(std::move(step)) {}

  [[nodiscard]] bool is_at_end(double /*periodicity*/) const { return n_cycles == control.most_cycles; }
  void step_through_period() {
    step_through_cycle();
    ++n_cycles;
  }
  [[nodiscard]] bool is_in_start() const { return n_cycles < control.least_cycles; }
  [[nodiscard]] double change() const { return watch.periodicity(); }
  [[nodiscard]] bool goes_on(double periodicity, double /*change*/) const { return periodicity > control.periodicity; }
};

/// Steps whole cycles: step is called with the number of each step, from 0 on.
template <class Contact, class Step>
SurfaceHistory history_of(const Contact& contact, SurfaceWatch& watch, int steps_per_cycle,
                          const SurfaceControl& control, const Step& step) {
  SecondAlgorithm second;
  long n = 0;
  SurfaceWay way(watch, control, [&] {
    for (int k = 0; k < steps_per_cycle; ++k) {
      step(n++);
      if (control.has_second_algorithm) second.see(contact);
    }
  });
  drive_to_period(way, {});
  auto history = watch.report();
  if (control.has_second_algorithm) history.second_difference = second.difference();
  return history;
}

}  // namespace

SurfaceHistory vector_friction_history(VectorFriction friction, const std::function<VectorXd(long)>& ring_pressure,
                                       const RingProblems& rings, const SurfaceControl& control) {
  SurfaceWatch watch(rings, friction.op().grid(), friction.steps_per_cycle());
  return history_of(friction, watch, friction.steps_per_cycle(), control, [&](long n) {
    const VectorXd pressure = ring_pressure(n);
    friction.step(pressure);
    watch.see(friction, pressure.replicate(1, friction.limit.cols()));
  });
}

SurfaceHistory coupled_contact_history(CoupledContact contact, const RingProblems& rings,
                                       const SurfaceControl& control) {
  SurfaceWatch watch(rings, contact.friction.op().grid(), contact.friction.steps_per_cycle());
  return history_of(contact, watch, contact.friction.steps_per_cycle(), control, [&](long) {
    const double before = contact.depth;
    contact.step();
    watch.see(contact, contact.depth - before);
  });
}

}  // namespace fretval::fem
