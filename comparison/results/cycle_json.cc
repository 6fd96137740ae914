#include "comparison/reference/mdr_document.h"
#include "comparison/results/case_result.h"
#include "comparison/results/period_steps.h"
#include "comparison/support/constants.h"
#include "comparison/support/statistics.h"
#include "fem/ring_contact/stick_zone/slip_decay.h"
#include "mdr/springs/spring_fields.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr int n_digits = 5;

template <class Numbers>
ordered_json list_of(const Numbers& numbers, double unit = 1) {
  auto list = ordered_json::array();
  for (const double number : numbers) list.push_back(to_digits(number * unit, n_digits));
  return list;
}

/// Columns of equal steps at a stride, from the first one given on.
std::vector<Eigen::Index> every_so_many(Eigen::Index n, Eigen::Index stride, Eigen::Index first) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index k = first; k < n; k += stride) columns.push_back(k);
  return columns;
}

Eigen::Index stride_for(Eigen::Index n, Eigen::Index most) {
  return (n + most - 1) / most;
}

/// Columns of the instants shown, the last one at the end of the period.
std::vector<Eigen::Index> frames_of(const FeAnswer& fe, Eigen::Index most) {
  if (!fe.normal.pieces.empty()) return columns_at_equal_times(fe, most);
  const auto n = fe.friction.traction.cols(), stride = stride_for(n, most);
  return every_so_many(n, stride, (n - 1) % stride);
}

/// Columns at which zones are shown, at equal parts of the period also where steps are not equal.
std::vector<Eigen::Index> zones_shown(const FeAnswer& fe, Eigen::Index most) {
  if (!fe.normal.pieces.empty()) return columns_at_equal_times(fe, most);
  const auto n = fe.friction.traction.cols();
  return every_so_many(n, stride_for(n, most), 0);
}

/// Time of the end of a step in the period, s.
double end_of_step(const CaseResult& result, Eigen::Index k) {
  const auto& normal = result.fe.fe.normal;
  const double step = 2 * pi / normal.steps_per_cycle, end = normal.pieces.empty()
                                                                 ? static_cast<double>(k + 1) * step
                                                                 : normal.pieces[static_cast<std::size_t>(k)].end;
  return end / result.fem_case.units.angular_frequency;
}

char letter_of(fem::RingZone zone) {
  return "osfb"[static_cast<std::size_t>(zone)];
}

/// at_end: pressure and traction at the end of the period, otherwise at the largest indentation.
ordered_json springs_json_of_cycle(const SpringAnswer& answer, const mdr::PronyBody& body, bool at_end) {
  const auto& history = answer.history;
  const auto fields = mdr::spring_fields(answer.bed, body, at_end ? history.last : history.deepest);
  constexpr int n_points = 120;
  const double end = answer.bed.position[answer.bed.position.size() - 1];
  std::vector<double> r, p, tau;
  for (int i = 0; i < n_points; ++i) {
    r.push_back((i + 0.5) * end / n_points);
    p.push_back(mdr::pressure(fields, r.back()));
    tau.push_back(mdr::traction(fields, r.back()));
  }
  return {{"r", list_of(r)},
          {"p", list_of(p)},
          {"tau", list_of(tau)},
          {"d", list_of(history.indentation)},
          {"u_x", list_of(history.tangential_displacement)},
          {"F_N", list_of(history.normal_force)},
          {"F_x", list_of(history.tangential_force)},
          {"friction_work", history.friction_work}};
}

std::optional<ordered_json> springs_of(const CaseResult& result) {
  const bool unworn = result.input.wear == Case::Wear::unworn && !result.input.wear_kinetics;
  const bool repeats = result.fem_case.has_period();
  if (!result.is_compared() || !unworn || !repeats || result.input.sweep || result.mdr.as<GrossSlipShare>() ||
      !why_no_springs(result.input).empty())
    return {};
  try {
    return springs_json_of_cycle(spring_answer(result.input, {200, 120, 8, 1e-5}), result.mdr_case.body,
                                 result.mdr_case.path.has_value());
  } catch (const std::runtime_error&) {
    return {};  // they are no part of the answer
  }
}

}  // namespace

ordered_json cycle_json(const CaseResult& result) {
  const auto& normal = result.fe.fe.normal;
  const auto& friction = result.fe.fe.friction;
  const auto& units = result.fem_case.units;
  const auto& radii = result.fe.fe.body->radii;
  const Eigen::Index n = friction.traction.cols(), n_rings = friction.traction.rows();
  const long first = friction.n_steps + 1 - n;
  // Rings that stick may be at their friction limit without slip: they are told by their number.
  const auto& fe = result.fe.fe;
  const auto& stuck = fe.rings.stuck;
  const Eigen::Index n_stuck = fe.as<ZoneAnswer>() ? 0 : is_pass(fe.motion_kind) ? stuck.first_slip : stuck.shakedown;
  ordered_json json{{"r", list_of(std::vector<double>(radii.begin() + 1, radii.end()), units.length)},
                    {"t", ordered_json::array()},
                    {"p", ordered_json::array()},
                    {"tau", ordered_json::array()},
                    {"zones", ordered_json::array()}};
  for (const auto k : frames_of(result.fe.fe, 48)) {
    json["t"].push_back(to_digits(end_of_step(result, k), n_digits));
    json["p"].push_back(list_of(Eigen::VectorXd(normal.pressure.col(normal.column(first + k))), units.pressure()));
    json["tau"].push_back(list_of(Eigen::VectorXd(friction.traction.col(k)), units.pressure()));
  }
  for (const auto k : zones_shown(result.fe.fe, 360)) {
    std::string zones;
    for (Eigen::Index i = 0; i < n_rings; ++i) {
      const auto zone = zone_of(normal.pressure(i, normal.column(first + k)), friction.traction(i, k),
                                result.fem_case.friction_coefficient);
      zones += i < n_stuck && zone != fem::RingZone::open ? 's' : letter_of(zone);
    }
    json["zones"].push_back(zones);
  }
  if (const auto decay = fem::slip_decay(friction, stuck.shakedown); !decay.empty() && !is_pass(fe.motion_kind))
    json["slip_decay"] = list_of(decay);
  if (auto springs = springs_of(result)) json["mdr"] = std::move(*springs);
  return json;
}

}  // namespace fretval
