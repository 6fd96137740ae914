#include "fem/wear/wear_course.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/contact/force_balance.h"
#include "fem/contact/gross_slip.h"

namespace fretval::fem {
namespace {

/// Over the largest jump: the first one, and the last one before the contact slides.
constexpr double shortest_jump = 0.05;
constexpr double largest_growth = 3;  // of one jump over the last one
constexpr double too_much = 2;        // of the largest jump

/// Radius of the disc whose area is that of the given numbers of rings on the rays.
double radius_of(const std::vector<double>& radii, const std::vector<Eigen::Index>& n_rings) {
  double squares = 0;
  for (const auto n : n_rings) squares += radii[static_cast<std::size_t>(n)] * radii[static_cast<std::size_t>(n)];
  return std::sqrt(squares / static_cast<double>(n_rings.size()));
}

WearPoint point_of(const WearingContact& contact, double cycles) {
  const auto& period = contact.period();
  const auto& radii = contact.contact().radii();
  const auto& areas = contact.contact().areas();
  const auto n = static_cast<Eigen::Index>(radii.size()) - 1, n_rays = areas.size() / n;
  const Eigen::VectorXd worn = contact.worn();
  std::vector<Eigen::Index> pressed, stuck;
  for (Eigen::Index ray = 0; ray < n_rays; ++ray) {
    const auto pressure = period.largest_pressure.segment(ray * n, n), path = period.path.segment(ray * n, n);
    Eigen::Index n_pressed = n, n_stuck = 0;
    while (n_pressed > 0 && pressure[n_pressed - 1] == 0) --n_pressed;
    while (n_stuck < n_pressed && path[n_stuck] == 0) ++n_stuck;
    pressed.push_back(n_pressed);
    stuck.push_back(n_stuck);
  }
  return {cycles,          areas.dot(worn),           areas.dot(period.rate), period.friction_work,
          worn.maxCoeff(), radius_of(radii, pressed), radius_of(radii, stuck)};
}

struct Jump {
  double cycles, deepest;  ///< worn off
  double error;            ///< what both ways differ by
};

/// Worn depths to second order in n, from those after n cycles taken at once and in two halves, each of first order. A
/// pressure that dies out as exp(-n) falls to 1/(1 + n) at once, and by the extrapolation more would be worn off than
/// there is where n > 2 + 2 sqrt(2): rings whose wear has fallen further keep the depth in two halves.
Eigen::VectorXd extrapolated(const Eigen::VectorXd& at_once, const Eigen::VectorXd& in_halves,
                             const Eigen::VectorXd& rate_before, const Eigen::VectorXd& rate_after) {
  const double least = 1 / (3 + 2 * std::sqrt(2));
  return (rate_after.array() > least * rate_before.array()).select(2 * in_halves - at_once, in_halves);
}

/// A jump over n cycles, or over fewer if those would wear off too much or let the whole contact slide. Empty: even the
/// shortest jump lets it slide.
std::optional<Jump> jump(WearingContact& contact, double n_cycles, double largest) {
  const Eigen::VectorXd before = contact.worn(), rate_before = contact.period().rate;
  const auto is_shortest = [&](double n) { return n * rate_before.maxCoeff() <= shortest_jump * largest; };
  while (true) {
    try {
      WearingContact at_once = contact, in_halves = contact;
      at_once.wear_off(n_cycles);
      const double deepest = (at_once.worn() - before).maxCoeff();
      if (deepest > too_much * largest) {
        n_cycles *= largest / deepest;
        continue;
      }
      in_halves.wear_off(n_cycles / 2);
      in_halves.settle();
      in_halves.wear_off(n_cycles / 2);
      const double error = (in_halves.worn() - at_once.worn()).lpNorm<Eigen::Infinity>();
      const auto worn = extrapolated(at_once.worn(), in_halves.worn(), rate_before, at_once.period().rate);
      in_halves.take_worn(worn.cwiseMax(before));
      in_halves.settle();
      contact = std::move(in_halves);
      return Jump{n_cycles, deepest, error};
    } catch (const GrossSlip&) {
      if (is_shortest(n_cycles)) return std::nullopt;
    } catch (const NoBalance&) {  // so near to sliding that roundoff decides; a shorter jump stays away from there
      if (is_shortest(n_cycles)) throw;
    }
    n_cycles /= 2;
  }
}

/// Whether points still slip after a jump in which they should have lost, by how they slip now, as much as makes a
/// largest jump in it roundoff: then their slip is roundoff.
bool wears_by_roundoff(const WearingContact& contact, double n_cycles, double largest) {
  return n_cycles * contact.period().rate.maxCoeff() > largest / std::numeric_limits<double>::epsilon();
}

double volume_after(const std::vector<WearPoint>& curve, double cycles) {
  const auto after = std::find_if(curve.begin() + 1, curve.end() - 1,
                                  [cycles](const WearPoint& point) { return point.cycles >= cycles; });
  const auto& [from, to] = std::tie(*(after - 1), *after);
  return from.volume + (to.volume - from.volume) * (cycles - from.cycles) / (to.cycles - from.cycles);
}

bool is_progressive(const WearCourse& course) {
  const auto& last = course.curve.back();
  if (last.stick_radius > 0 || !(last.deepest > course.first.largest_indentation)) return false;
  const double half = volume_after(course.curve, last.cycles / 2);
  return last.volume - half >= half - volume_after(course.curve, last.cycles / 4);
}

void add_point(WearState& state, double cycles) {
  state.course.curve.push_back(point_of(state.contact, cycles));
  state.course.worn.push_back(state.contact.worn());
  state.course.largest_pressure.push_back(state.contact.period().largest_pressure);
}

void begin(WearState& state, const WearControl& control) {
  state.contact.start();
  state.contact.settle();
  add_point(state, 0);
  state.course.first = state.contact.period();
  state.next_jump = shortest_jump * control.largest_jump / state.contact.period().rate.maxCoeff();
  state.goes_on = state.course.curve.front().volume_rate > 0;
}

/// Why the course would end now; nothing_left: it goes on, unless nothing wears any more.
WearEnd end_by_course(const WearCourse& course, const WearControl& control) {
  const double share = control.rate_fallen_to;
  if (share > 0 && course.curve.back().volume_rate <= share * course.curve.front().volume_rate) return WearEnd::rate;
  return is_progressive(course) ? WearEnd::progressive : WearEnd::nothing_left;
}

}  // namespace

void wear_on(WearState& state, const WearControl& control, const WearObserver& after_jump) {
  auto& [contact, course, next, goes_on] = state;
  if (course.curve.empty()) begin(state, control);
  while (goes_on) {
    const double done = course.curve.back().cycles, left = control.most_cycles - done;
    const auto made = jump(contact, std::min(next, left), control.largest_jump);
    if (!made) {
      course.end = WearEnd::slides;
      break;
    }
    const auto& [cycles, deepest, error] = *made;
    add_point(state, cycles >= left ? control.most_cycles : done + cycles);
    ++course.n_jumps;
    course.largest_jump_error = std::max(course.largest_jump_error, error);
    next = cycles * std::min(control.largest_jump / deepest, largest_growth);
    course.end = cycles >= left ? WearEnd::cycles : end_by_course(course, control);
    goes_on = course.end == WearEnd::nothing_left && course.curve.back().volume_rate > 0 &&
              (cycles < done || deepest > control.accuracy) &&
              !wears_by_roundoff(contact, cycles, control.largest_jump);
    if (after_jump) after_jump(state);
  }
  course.last = contact.period();
  course.n_cycles_stepped = contact.n_cycles_stepped();
}

}  // namespace fretval::fem
