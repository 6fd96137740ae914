#pragma once

#include "comparison/results/case_result.h"
#include "tests/comparison/read_case.h"

namespace fretval {

/// A result whose every number is another one, for those who write it. A length of 1 is 2 m, a depth 0.5 m, a pressure
/// 2.5 Pa, a force 10 N, and a step, a quarter of a cycle, takes 1 s. Two rings; three cycles, of which the last is the
/// period. The case is the valid one of the tests: parabola of R = 1e-2 m, d = 1e-4 m + 2e-5 m cos.
inline CaseResult made_up_result() {
  constexpr double pi = 3.14159265358979323846;
  auto prepared = prepared_case();
  prepared.input.fields = Case::Fields::none;
  prepared.fem.units = {2, 0.5, 10, pi / 2};
  prepared.fem.motion = fem::one_frequency(0.75, 0.25, 0.125, pi / 3);
  prepared.fem.motion.n_ramp_cycles = 1;
  BodySummary body{};
  body.mesh_quality.n_cells = 101;
  body.mesh_quality.n_nodes = 102;
  body.mesh_quality.min_scaled_jacobian = 0.625;
  body.mesh_quality.max_aspect_ratio = 4.5;
  body.cost = {1.5, 2.5, 3.5, 6.5};
  body.n_dofs = 103;
  body.n_contact_nodes = 104;
  body.radii = {0, 0.5, 1.5};

  ProvedAnswer answer{};
  answer.n_refinements = 5;
  answer.cost = {6, 720, 60, 7.5, {4, 2}};
  auto& fe = answer.fe;
  fe.contact_radius_max = 1.25;
  fe.stick_radius_first_slip = 0.5;
  fe.stick_radius_shakedown = 0.75;
  fe.normal_force_max = 42.5;
  fe.axis_pressure_max = 12.5;
  fe.of_kind = NoWearEvidence{0.01, 0.02, 1.03, 1.04};
  fe.n_cycles = 3;
  fe.n_steps = 12;
  fe.seconds = {4.5, 5.5};
  fe.body = std::make_shared<const BodySummary>(body);

  auto& normal = fe.normal;
  normal.steps_per_cycle = 4;
  normal.n_cycles = 2;
  normal.periodicity = 1e-6;
  normal.first_balance = pi / 2;
  normal.pressure = (Eigen::MatrixXd(2, 4) << 4, 3, 2, 5, 1, 0, 0, 2).finished();
  normal.force = Eigen::Vector4d(1, 2, 3, 4);
  normal.force_beyond = Eigen::Vector4d(0.5, 0, 0, 0.25);
  normal.deepest_displacement = Eigen::Vector2d(0.8, 0.3);
  normal.indentation = Eigen::Vector4d(0.75, 0.5, 0.75, 1);
  normal.largest_indentation = 1;

  auto& friction = fe.friction;
  friction.n_cycles = 3;
  friction.n_steps = 12;
  friction.periodicity = 2e-6;
  friction.traction = (Eigen::MatrixXd(2, 4) << -1, -2, 1, 3, 0.5, 0, -0.5, 0).finished();
  friction.force = Eigen::Vector4d(-1, -2, 1, 2);
  friction.indenter = 0.125 * Eigen::Vector4d(-std::sqrt(0.75), -0.5, std::sqrt(0.75), 0.5);
  friction.dissipated_energy = 0.25;
  friction.period_slip = Eigen::Vector2d(0, 0.2);
  friction.first_slip_margin = Eigen::Vector2d(-0.1, 0.4);
  friction.shakedown_margin = Eigen::Vector2d(0.2, -0.4);

  MdrAnswer mdr{1.5, 1.1, 0.45, 6e-4, 1.9, 40};
  mdr.of_kind = LimitingAnswer{0.95};
  mdr.axis_pressure = mdr::AxisPressure{12, 0.1};
  const Comparison comparison{
      {Quantity::normal_force_max, {0.0625, 0.1, Verdict::agree, ErrorBar{{{ErrorSource::rings, 0.03125, 2.5}}}}},
      {Quantity::stick_radius_shakedown, {0.15, 0.125, Verdict::disagree, std::nullopt}}};
  return {prepared.input, prepared.mdr, prepared.fem, mdr, Proof::bars, answer, comparison};
}

/// What MDR says of its force, in N, at every quarter of a cycle.
inline mdr::NormalResponse made_up_reference() {
  mdr::NormalResponse reference{};
  reference.time = {0, 1, 2, 3, 4};
  reference.normal_force = {100, 200, 300, 400, 100};
  return reference;
}

}  // namespace fretval
