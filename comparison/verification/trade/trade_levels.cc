#include "comparison/verification/trade/trade_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/body.h"
#include "comparison/support/resident_memory.h"
#include "comparison/support/stopwatch.h"
#include "fem/full_model/full_history.h"
#include "fem/history/friction_history.h"
#include "fem/history/static_contact.h"
#include "fem/support/solver_error.h"
#include "mdr/springs/spring_history.h"
#include "mdr/stick/stick_radius.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

constexpr double closed_form_seconds = 0.5;
constexpr double right_angle = 3.14159265358979323846 / 2;

/// Stops at the first chance.
fem::HistoryControl few_cycles(int steps_per_cycle) {
  return {steps_per_cycle, 16, std::numeric_limits<double>::max()};
}

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Condensed histories with what full ones are held against at every step: from the start on.
struct Recorded {
  fem::NormalHistory normal;
  std::vector<Eigen::VectorXd> pressure;  ///< at the start and after every computed step
};

Recorded recorded_normal(const fem::ContactProblem& problem, const FemCase& fem, const Eigen::VectorXd& profile) {
  const int steps = fem.resolution.steps_per_cycle;
  fem::NormalContact contact(problem, fem.relaxation, profile, fem.motion, steps);
  std::vector<Eigen::VectorXd> pressure{contact.pressure};
  auto normal = fem::normal_history(std::move(contact), few_cycles(steps),
                                    [&](const fem::NormalContact& now) { pressure.push_back(now.pressure); });
  return {std::move(normal), std::move(pressure)};
}

/// Over a number of steps, the last cycle as often as need be.
Eigen::MatrixXd pressures_over(const Recorded& recorded, long n_steps) {
  Eigen::MatrixXd pressure(recorded.pressure.front().size(), 1 + n_steps);
  const auto n_recorded = static_cast<long>(recorded.pressure.size());
  for (long k = 0; k <= n_steps; ++k)
    pressure.col(k) = k < n_recorded ? recorded.pressure[static_cast<std::size_t>(k)]
                                     : Eigen::VectorXd(recorded.normal.pressure.col(recorded.normal.column(k)));
  return pressure;
}

FemCase short_case(const FemCase& whole, const Resolution& resolution) {
  FemCase fem = at_resolution(whole, resolution);
  fem.motion.n_ramp_cycles = 1;
  if (!fem.motion.phase) fem.motion.phase = right_angle;
  return fem;
}

void measure_normal(const Body& body, const FemCase& fem, const Eigen::VectorXd& profile, const Recorded& condensed,
                    FullPoint& point) {
  Stopwatch watch;
  const auto full = fem::full_normal_history(body.normal.space, fem.relaxation, profile, fem.motion,
                                             fem.resolution.steps_per_cycle, condensed.normal.n_cycles);
  point.normal_seconds = watch.lap();
  point.n_normal_steps = full.pressure.cols() - 1;
  point.pressure_difference = largest_difference(full.pressure, pressures_over(condensed, condensed.normal.n_steps()));
}

void measure_friction(const Body& body, const FemCase& fem, const Recorded& normal, FullPoint& point) {
  const int steps = fem.resolution.steps_per_cycle;
  const double mu = fem.friction_coefficient;
  fem::WatchedFriction friction(body.tangential->contact, fem.relaxation, mu, fem.motion, steps);
  for (std::size_t k = 1; k < normal.pressure.size(); ++k) friction.step(normal.pressure[k]);
  const auto condensed = fem::friction_history(std::move(friction), normal.normal, few_cycles(steps));
  const auto pressure = pressures_over(normal, condensed.n_steps);
  Stopwatch watch;
  const auto full = fem::full_friction_history(body.tangential->space, fem.relaxation, mu, fem.motion, pressure, steps,
                                               condensed.n_cycles);
  point.friction_seconds = watch.lap();
  point.n_friction_steps = full.traction.cols() - 1;
  point.traction_difference = largest_difference(full.traction.rightCols(steps), condensed.traction);
}

void measure(const PreparedCase& prepared, FullPoint& point) {
  const auto fem = short_case(prepared.fem, point.resolution);
  const ResidentGrowth growth;
  const auto body = make_body(fem.body);
  point.n_dofs = body.n_dofs();
  point.body_seconds = body.cost.total();
  const Eigen::VectorXd profile = fem::ring_means(body.normal.contact.compliance, fem.profile);
  const auto normal = recorded_normal(body.normal.contact, fem, profile);
  measure_normal(body, fem, profile, normal, point);
  if (body.tangential) measure_friction(body, fem, normal, point);
  point.memory_bytes = growth.peak_bytes();
}

mdr::SpringHistory stepped_springs(const PreparedCase& prepared, const SpringSetting& setting) {
  const auto& profile = prepared.mdr.profile;
  const auto motion = harmonic_motion_of(prepared.input.motion);
  const double period = mdr::common_period(motion), ramp = setting.n_ramp_periods * period;
  const double outer = 1.001 * mdr::inverse_transform(profile, mdr::maximum_indentation(motion));
  const auto bed = mdr::spring_bed(profile, std::min(outer, mdr::end_radius(profile)), setting.n_springs);
  return mdr::spring_history(bed, prepared.mdr.body, prepared.mdr.friction_coefficient,
                             {mdr::ramped_path(motion, ramp), {}, {}},
                             {period, setting.steps_per_period, setting.n_ramp_periods, 2000, setting.periodicity});
}

Quantities quantities_of(const mdr::SpringHistory& history, const PreparedCase& prepared) {
  const auto& units = prepared.fem.units;
  const auto radius = [&](double depth) {
    return depth > 0 ? mdr::inverse_transform(prepared.mdr.profile, depth) / units.length : 0;
  };
  const double force = *std::max_element(history.normal_force.begin(), history.normal_force.end());
  return {{Quantity::normal_force_max, std::log(force / units.force())},
          {Quantity::stick_radius_first_slip, radius(history.depths.first_slip)},
          {Quantity::stick_radius_shakedown, radius(history.depths.shakedown)}};
}

}  // namespace

ClosedForm closed_form(const PreparedCase& prepared) {
  const double never = std::numeric_limits<double>::infinity();
  ClosedForm result{{}, {}, never, never, 0};
  Stopwatch watch;
  for (double seconds = 0; seconds < closed_form_seconds; ++result.n_repetitions) {
    result.answer = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
    const double lap = watch.lap();
    const auto& mdr_case = prepared.mdr;
    mdr::stick_radii(mdr_case.profile, mdr_case.body, mdr_case.friction_coefficient, mdr_case.motion);
    result.stick_radii_seconds = std::min(result.stick_radii_seconds, watch.lap());
    result.seconds = std::min(result.seconds, lap);
    seconds += lap;
  }
  result.measures = quantities_of(result.answer, prepared.fem.units, prepared.fem.worn_edge.has_value());
  return result;
}

bool has_springs(const PreparedCase& prepared) {
  return !prepared.mdr.limiting && prepared.input.motion.phase;
}

SpringPoint spring_point(const PreparedCase& prepared, const SpringSetting& setting, const Quantities& reference,
                         int n_repetitions) {
  SpringPoint point;
  point.setting = setting;
  // Bed 3, state 4 and two per branch, minima 3 in each of two directions and two spans, slip and mean traction.
  const double per_spring = 3 + 4 + 2.0 * static_cast<double>(prepared.mdr.body.branch_moduli.size()) + 12 + 4;
  point.memory_bytes = 8 * (per_spring * setting.n_springs + 3.0 * setting.steps_per_period);
  point.seconds = std::numeric_limits<double>::infinity();
  try {
    Stopwatch watch;
    for (int run = 0; run < n_repetitions; ++run) {
      const auto history = stepped_springs(prepared, setting);
      point.seconds = std::min(point.seconds, watch.lap());
      point.n_periods = history.n_periods;
      point.errors = errors_of(quantities_of(history, prepared), reference);
    }
  } catch (const std::runtime_error& error) {
    point.failure = error.what();
  }
  return point;
}

double FullPoint::seconds_per_normal_step() const {
  return n_normal_steps > 0 ? normal_seconds / static_cast<double>(n_normal_steps) : 0;
}

double FullPoint::seconds_per_friction_step() const {
  return n_friction_steps > 0 ? friction_seconds / static_cast<double>(n_friction_steps) : 0;
}

double FullPoint::extrapolated_seconds(long normal_steps, long friction_steps) const {
  return body_seconds + seconds_per_normal_step() * static_cast<double>(normal_steps) +
         seconds_per_friction_step() * static_cast<double>(friction_steps);
}

FullPoint full_point(const PreparedCase& prepared, const Resolution& resolution) {
  FullPoint point;
  point.resolution = resolution;
  try {
    measure(prepared, point);
  } catch (const fem::SolverError& error) {
    point.failure = error.what();
  } catch (const meshes::MeshError& error) {
    point.failure = error.what();
  }
  return point;
}

}  // namespace fretval
