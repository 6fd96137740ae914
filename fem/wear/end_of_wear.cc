#include "fem/wear/end_of_wear.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/ring_contact/stencil.h"
#include "fem/support/constants.h"
#include "fem/wear/ring_widths.h"

namespace fretval::fem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index most_apart = 8;  // rings from which the edge is read

/// Whether a ring is pressed all the time and does not slip.
bool sticks(const WearingContact::Period& last, Index ring) {
  return last.path[ring] == 0 && last.pressure.row(ring).minCoeff() > 0;
}

/// Whether what slips, or opens in a cycle, bears next to nothing.
bool ends_in_stick(const VectorXd& areas, const WearCourse& course) {
  double slipping = 0;
  for (Index i = 0; i < areas.size(); ++i)
    if (!sticks(course.last, i)) slipping += areas[i] * course.last.largest_pressure[i];
  return slipping < as_good_as_nothing * areas.dot(course.first.largest_pressure);
}

/// Depths of the n innermost rings, a column for each instant. With a prescribed force each is that of the edge of a
/// disc which bears it alone, and which ends in the middle of the ring.
MatrixXd depths_of_discs(const PunchSeries& series, const MatrixXd& tractions, Index n, bool bears_force) {
  MatrixXd depths = series.depths_of_instants(tractions).topRows(n);
  if (!bears_force) return depths;
  Eigen::RowVectorXd beyond = Eigen::RowVectorXd::Zero(depths.cols());
  for (Index j = n - 1; j >= 0; --j) {
    const double whole = series.punch_force(j + 1), half = (whole - series.punch_force(j)) / 2;
    const Eigen::RowVectorXd half_of_ring = half * depths.row(j);
    beyond += half_of_ring;
    depths.row(j) += beyond / (whole - half);
    beyond += half_of_ring;
  }
  return depths;
}

/// The reserve of the stuck rings in the last period, see end_of_wear.
VectorXd reserve_of(const WornContact& contact, const WearingContact::Period& last, Index n_stuck) {
  const auto &pressed = contact.normal.series, &sheared = contact.tangential.series;
  const auto& motion = contact.motion;
  const double grip = contact.friction_coefficient * pressed.force_per_radius() / sheared.force_per_radius();
  const MatrixXd limit = grip * depths_of_discs(pressed, last.pressure, n_stuck, motion.normal_force);
  const MatrixXd sheared_by = depths_of_discs(sheared, last.traction, n_stuck, motion.tangential_force);
  const StepTimes times(motion, contact.steps_per_cycle);
  const auto piece = [&](Index k) {
    auto step = times.in_piece(k);
    if (step) step->fraction = RelaxationStep(contact.relaxation, step->duration()).fraction();
    return step;
  };
  RunningMinimum forward(n_stuck, -infinity), backward(n_stuck, -infinity);
  const auto add = [&](Index k) {
    forward.add(limit.col(k) - sheared_by.col(k), piece(k));
    backward.add(limit.col(k) + sheared_by.col(k), piece(k));
  };
  const Index n_steps = limit.cols();
  for (Index k = std::max<Index>(0, n_steps - RunningMinimum::n_before); k < n_steps; ++k) add(k);
  forward.restart();
  backward.restart();
  for (Index k = 0; k < n_steps; ++k) add(k);
  VectorXd reserve = (forward.value() + backward.value()) / 2;
  // Under a force depths go as 1/r, and what the disc has to spare of the force is smooth.
  if (motion.has_forces()) reserve.array() *= pressed.radii().head(n_stuck).array();
  return reserve;
}

/// Where the parabola through the last ring and two others inside vanishes, each `apart` of the one before. No further
/// away than half of the way between them.
std::optional<double> root(const VectorXd& radii, const VectorXd& reserve, Index apart) {
  const Index last = reserve.size() - 1;
  Eigen::Vector3d x, y;
  for (Index k = 0; k < 3; ++k) {
    x[k] = radii[last - (2 - k) * apart];
    y[k] = reserve[last - (2 - k) * apart];
  }
  const double reach = (x[2] - x[0]) / 2;
  return root_between(Stencil{x, y, 0, 3}, x[2] - reach, x[2] + reach);
}

/// Depths of the disc up to an edge whose rings are displaced like this; the ring at the edge has a share of its own.
VectorXd depths_up_to(double edge, const PunchSeries& series, const VectorXd& displacement) {
  const VectorXd& edges = series.edges();
  VectorXd depths = series.displacements(displacement);
  for (Index i = 0; i < depths.size(); ++i)
    depths[i] *= std::clamp((edge - edges[i]) / (edges[i + 1] - edges[i]), 0.0, 1.0);
  return depths;
}

/// Depths of the rings that stick, on what is left of the indenter at its largest indentation.
VectorXd depths_of_stuck(const ContactProblem& normal, const WearingContact::Period& last, const VectorXd& height) {
  VectorXd of_stuck = height;
  for (Index i = 0; i < of_stuck.size(); ++i)
    if (!sticks(last, i)) of_stuck[i] += 2 * last.largest_indentation;
  return normal.series.depths(static_contact(normal, of_stuck, last.largest_indentation).pressure);
}

/// The worn depths of whole rings, carried over to an edge.
VectorXd carried_over(const WornContact& contact, const VectorXd& unworn, const WearCourse& course, double edge) {
  const auto& [compliance, solver, series] = contact.normal;
  const auto& last = course.last;
  const VectorXd &start = course.worn.front(), &whole = course.worn.back();
  const VectorXd stuck = depths_of_stuck(contact.normal, last, unworn + whole);
  VectorXd worn = whole;  // inside the edge nothing wears, whatever its rings did
  for (Index i = 0; i < worn.size(); ++i)
    if (!sticks(last, i)) worn[i] = start[i];
  VectorXd disc = depths_up_to(edge, series, (last.largest_indentation - (unworn + worn).array()).matrix());
  double rise = 0;
  if (contact.motion.normal_force) {
    const VectorXd one = depths_up_to(edge, series, VectorXd::Ones(disc.size()));
    const VectorXd forces = series.loads_of_depths(series.loads_of_depths(VectorXd::Ones(disc.size())));
    rise = forces.dot(disc - stuck) / forces.dot(one);
    disc -= rise * one;
  }
  const VectorXd sinks = (*compliance.matrix * series.tractions(stuck - disc)).cwiseQuotient(compliance.areas);
  for (Index i = 0; i < worn.size(); ++i)
    if (series.edges()[i + 1] > edge && (whole[i] > start[i] || sticks(last, i)))
      worn[i] = std::max(whole[i] - rise + sinks[i], start[i]);
  return worn;
}

}  // namespace

EndOfWear end_of_wear(const WornContact& contact, const VectorXd& unworn, const WearCourse& course) {
  const auto& compliance = contact.normal.compliance;
  const auto whole_rings = [&]() -> EndOfWear {
    const double radius = course.curve.back().stick_radius;
    if (radius == 0) return {{0, 0}, course.worn.back()};
    const auto [inside, outside] = rings_at(compliance.radii, radius);
    return {{radius, std::max(inside, outside)}, course.worn.back()};
  };
  Index n = 0;
  while (n < compliance.areas.size() && sticks(course.last, n)) ++n;
  const Index apart = std::min(most_apart, (n - 1) / 4);
  if (!contact.normal.series.is_half_space() || apart < 2 || !ends_in_stick(compliance.areas, course))
    return whole_rings();
  // The depths of the pressure fall towards the edge, those of the traction hardly change: radii are those of the
  // pressure.
  const auto effective = effective_radii(compliance);
  const VectorXd reserve = reserve_of(contact, course.last, n);
  const auto read = root(effective.of_rings, reserve, apart), other = root(effective.of_rings, reserve, apart / 2);
  if (!read || !other) return whole_rings();
  return {
      {*read, 2 * std::abs(*read - *other) + effective.scatter}, carried_over(contact, unworn, course, *read), true};
}

}  // namespace fretval::fem
