#include "fem/ring_contact/free_surface.h"

#include <algorithm>
#include <utility>

#include "fem/ring_contact/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Neighbouring rings that lifted in one retreat of the contact.
struct Run {
  Index begin, end;
};

Run run_around(Index ring, const Eigen::VectorXi& retreat) {
  Run run{ring, ring + 1};
  while (run.begin > 0 && retreat[run.begin - 1] == retreat[ring]) --run.begin;
  while (run.end < retreat.size() && retreat[run.end] == retreat[ring]) ++run.end;
  return run;
}

/// The polynomial through at most four rings of a run, from `first` on if the run has enough of them.
Stencil stencil_of(const Run& run, Index first, const Eigen::VectorXd& radii, const Eigen::VectorXd& values) {
  const Index n = std::min(n_stencil, run.end - run.begin);
  return {radii, values, std::clamp(first, run.begin, run.end - n), n};
}

/// The polynomial through the last rings of a run that ends at a kink, and through the value `there` at the kink, to
/// which the rings beyond it are continued.
Stencil stencil_up_to(double kink, double there, const Run& run, const Eigen::VectorXd& radii,
                      const Eigen::VectorXd& values) {
  const Index n = std::min(n_stencil - 1, run.end - run.begin);
  Eigen::Vector4d x, y;
  x.head(n + 1) << radii.segment(run.end - n, n), kink;
  y.head(n + 1) << values.segment(run.end - n, n), there;
  return {x, y, 0, n + 1};
}

/// Number of rings in contact around the centre.
Index count_pressed(const std::vector<BoxState>& contact) {
  const auto first_free =
      std::find_if(contact.begin(), contact.end(), [](BoxState ring) { return ring != BoxState::interior; });
  return first_free - contact.begin();
}

/// Slip in a step of displacements that bear no load: they relax.
void find_slip(const RelaxationStep& step, const RingState& state, Eigen::VectorXd& slip) {
  step.find_response_without_slip(state, standing_still, slip);
  slip /= step.instantaneous();
}

}  // namespace

std::optional<double> edge_of(const Opening& opening, const Eigen::VectorXd& radii, Index n_pressed) {
  const auto& values = opening.value;
  const auto& retreat = opening.retreat;
  const Index last = n_pressed - 1;
  if (retreat.size() == 0)
    return crossing(stencil_of({n_pressed, values.size()}, n_pressed, radii, values), radii[last], radii[n_pressed]);
  const auto outer = run_around(n_pressed, retreat);
  if (retreat[last] == retreat[n_pressed])
    return crossing(stencil_of(outer, last - 1, radii, values), radii[last], radii[n_pressed]);
  const auto outside = stencil_of(outer, outer.begin, radii, values);
  if (retreat[last] < retreat[n_pressed]) return crossing(outside, radii[last], radii[n_pressed]);
  const auto inner = run_around(last, retreat);
  const double kink = opening.lifted_below[last], there = outside(kink);
  if (there <= 0 || kink <= radii[inner.end - 1]) return crossing(outside, radii[last], radii[n_pressed]);
  return crossing(stencil_up_to(kink, there, inner, radii, values), radii[last], kink);
}

FreeSurface::FreeSurface(const PunchSeries& series, const RingState& state, Index n_pressed)
    : series_(series),
      state_(state),
      retreat_(Eigen::VectorXi::Constant(state.displacement.size(), never_touched)),
      lifted_below_(Eigen::VectorXd::Zero(state.displacement.size())),
      n_pressed_(n_pressed) {
  state_.displacement = series.displacements(state.displacement);
  retreat_.head(n_pressed).setConstant(never_lifted);
}

void FreeSurface::find_opening(const RelaxationStep& step, const Eigen::VectorXd& profile, double depth,
                               Opening& opening) const {
  auto& value = opening.value;
  find_slip(step, state_, value);
  value = state_.displacement - step.fraction() * value + profile;
  value.array() -= depth;
  opening.retreat = retreat_;
  opening.lifted_below = lifted_below_;
}

void FreeSurface::advance(const RelaxationStep& step, const RingState& state, const std::vector<BoxState>& contact,
                          double radius) {
  find_slip(step, state_, work_);
  step.advance(state_, standing_still, work_);
  const Index before = n_pressed_;
  n_pressed_ = count_pressed(contact);
  if (n_pressed_ > before) is_retreating_ = false;
  if (n_pressed_ < before) {
    if (!is_retreating_) {
      ++n_retreats_;
      began_at_ = std::exchange(radius_, 0);
    }
    is_retreating_ = true;
    const Index n_lifted = before - n_pressed_;
    const auto lifted = [&](auto&& values) { return values.segment(n_pressed_, n_lifted); };
    const auto take = [&](const auto& rings, auto&& values) {
      work_ = rings;
      series_.to_displacements(work_);
      lifted(values) = lifted(work_);
    };
    take(state.displacement, state_.displacement);
    for (Index branch = 0; branch < state_.memory.cols(); ++branch)
      take(state.memory.col(branch), state_.memory.col(branch));
    lifted(retreat_).setConstant(n_retreats_);
    lifted(lifted_below_).setConstant(began_at_);
  }
  if (!is_retreating_) radius_ = std::max(radius_, radius);
}

}  // namespace fretval::fem
