#include "fem/full_contact/surface_history.h"

#include <algorithm>
#include <utility>

#include "fem/full_contact/fields.h"
#include "fem/full_contact/slip_room.h"
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
      in_cycle_(ever_) {}

void SurfaceWatch::begin_cycle() {
  in_cycle_.setZero();
  path_ = 0;
  traction_before_ = std::exchange(traction_, {});
  pressure_.clear();
  limit_.clear();
  forces_.resize(3, steps_per_cycle_);
  dissipated_.push_back(0);
}

void SurfaceWatch::see(const VectorFriction& friction, const MatrixXd& pressure) {
  if (n_steps_ % steps_per_cycle_ == 0) begin_cycle();
  const MatrixXd margin = (friction.limit - lengths(friction.traction)).cwiseMax(0);
  const Eigen::ArrayXXd slips = (margin.array() <= at_its_limit * friction.limit.maxCoeff()).cast<double>();
  ever_ = ever_.max(slips);
  in_cycle_ += (friction.limit.array() > 0).select(lengths(friction.slip), infinity);
  path_ += friction.increment.norm();
  const MatrixXd reserve = rings_.tangential.series.depths_of_instants((slips > 0).select(0, margin));
  reserve_.add(Eigen::Map<const VectorXd>(reserve.data(), reserve.size()), friction.in_piece());
  pressure_.push_back(pressure);
  traction_.push_back(friction.traction);
  limit_.push_back(friction.limit);
  forces_.col(n_steps_ % steps_per_cycle_) = friction.forces();
  dissipated_.back() += friction.friction_work();
  ++n_steps_;
}

double SurfaceWatch::slip_of_stuck_point() const {
  constexpr double share = 1e-4;
  if (path_ > 0) return share * path_ / 4;
  return share * (in_cycle_.array() < infinity).select(in_cycle_, 0).maxCoeff();
}

MatrixXd SurfaceWatch::room() const {
  const double allowed = slip_of_stuck_point();
  MatrixXd room = MatrixXd::Zero(in_cycle_.rows(), in_cycle_.cols());
  const Index m = room.cols();
  const auto n = static_cast<Index>(traction_.size());
  VectorXd x(n), y(n), limit(n);
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < room.rows() && in_cycle_(i, j) <= allowed; ++i) {
      for (Index k = 0; k < n; ++k) {
        x[k] = traction_[static_cast<std::size_t>(k)](i, j);
        y[k] = traction_[static_cast<std::size_t>(k)](i, m + j);
        limit[k] = limit_[static_cast<std::size_t>(k)](i, j);
      }
      room(i, j) = slip_room(x, y, limit);
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
  MatrixXd largest = pressure_.front();
  for (const auto& pressure : pressure_) largest = largest.cwiseMax(pressure);
  history.contact = region_of(rings_.normal, grid_, largest);
  history.dissipated = dissipated_;
  history.forces = forces_;
  history.pressure = pressure_;
  history.traction = traction_;
  history.periodicity = change_between(traction_, traction_before_);
  return history;
}

SurfaceHistory vector_friction_history(VectorFriction friction,
                                       const std::function<Eigen::VectorXd(long)>& ring_pressure,
                                       const RingProblems& rings, int n_cycles) {
  SurfaceWatch watch(rings, friction.op().grid(), friction.steps_per_cycle());
  for (long step = 0; step < static_cast<long>(n_cycles) * friction.steps_per_cycle(); ++step) {
    const VectorXd pressure = ring_pressure(step);
    friction.step(pressure);
    watch.see(friction, pressure.replicate(1, friction.limit.cols()));
  }
  return watch.report();
}

SurfaceHistory coupled_contact_history(CoupledContact contact, const RingProblems& rings, int n_cycles) {
  const int n_steps = contact.friction.steps_per_cycle();
  SurfaceWatch watch(rings, contact.friction.op().grid(), n_steps);
  for (long step = 0; step < static_cast<long>(n_cycles) * n_steps; ++step) {
    contact.step();
    watch.see(contact.friction, contact.pressure);
  }
  return watch.report();
}

}  // namespace fretval::fem
