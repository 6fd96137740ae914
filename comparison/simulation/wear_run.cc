#include "comparison/simulation/wear_run.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "comparison/simulation/bodies/operator_key.h"
#include "comparison/simulation/wear_checkpoint.h"
#include "fem/contact/require_room.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/support/solver_error.h"
#include "histories_hash.h"

namespace fretval {
namespace {

/// The wear law in the units of the case: depths have a unit of their own, and so have lengths of slip.
fem::WearLaw law_in(const Units& units, const Case::WearKinetics& wear, double friction_coefficient) {
  const double coefficient =
      wear.law == Case::WearLaw::energy ? friction_coefficient * wear.coefficient : wear.coefficient;
  return {coefficient * std::pow(units.pressure(), wear.exponent), wear.exponent};
}

/// Text of all that the course depends on, bit for bit.
std::string description(const FemCase& fem, const fem::WearLaw& law, const fem::WearControl& control,
                        const fem::WornProfile& profile) {
  auto text = "wear " FRETVAL_HISTORIES_HASH "\n" + operator_key(fem.body, fem::lateral);
  const auto add = [&text](const auto& values) {
    text += '\n';
    for (const double value : values) text += fmt::format(" {:a}", value);
  };
  const auto add_motion = [&add](const std::vector<fem::Oscillation>& oscillations) {
    for (const auto& [amplitude, order, phase, across] : oscillations)
      add(std::array{amplitude, 1.0 * order, phase, 1.0 * across});
  };
  add(profile.unworn);
  add(profile.worn);
  add(std::array{fem.relaxation.relaxed, fem.relaxation.viscosity, fem.friction_coefficient});
  add(fem.relaxation.moduli);
  add(fem.relaxation.times);
  const auto& motion = fem.motion;
  add(std::array{motion.indentation, 1.0 * motion.normal_force, 1.0 * motion.tangential_force, 1.0 * motion.locked,
                 1.0 * motion.n_ramp_cycles, 1.0 * motion.n_creep_cycles, 1.0 * fem.steps_per_cycle()});
  add_motion(motion.normal);
  add_motion(motion.tangential);
  if (const auto& path = motion.path) {
    for (const auto* rows : {&path->time, &path->normal, &path->tangential, &path->transverse}) add(*rows);
    add(std::array{path->rest_normal, path->rest_tangential});
  }
  add(std::array{law.coefficient, law.exponent, control.most_cycles, control.rate_fallen_to, control.largest_jump,
                 control.accuracy});
  if (fem.kind == ContactKind::plane) add(std::array{1.0 * fem.full.coupled, 1.0 * fem.resolution.n_angles});
  return text + '\n';
}

}  // namespace

double widest_wear(const FemCase& fem, double largest_indentation) {
  double inner = 1, outer = 1;
  while (fem.profile(outer) < largest_indentation) inner = std::exchange(outer, 1.25 * outer);
  constexpr double close = 1e-3;
  while (outer - inner > close) {
    const double middle = (inner + outer) / 2;
    (fem.profile(middle) < largest_indentation ? inner : outer) = middle;
  }
  return outer;
}

bool stick_radius_moves(const FemCase& fem) {
  return fem.motion.has_forces() || fem.solid;
}

WornEdge settled_edge(const FemCase& fem, double unworn_stick_radius,
                      const std::function<WearPass(const WornEdge&)>& pass_at) {
  if (!stick_radius_moves(fem)) return {unworn_stick_radius, widest_wear(fem, 1)};
  const bool sinks = fem.motion.has_forces();
  constexpr int most_passes = 12;
  constexpr double reserve = 1.05, deeper = 1.5;
  double depth = sinks ? deeper : 1, stick_radius = unworn_stick_radius;
  for (int i = 0; i < most_passes; ++i) {
    const WornEdge edge{stick_radius, widest_wear(fem, depth)};
    try {
      const auto pass = pass_at(edge);
      if (pass.end == fem::WearEnd::progressive || pass.end == fem::WearEnd::slides) return {0, edge.outer};
      if (sinks) depth = reserve * pass.largest_indentation;
      const double before = std::exchange(stick_radius, pass.stick_radius);
      if (std::abs(stick_radius - before) <= pass.ring) return {stick_radius, widest_wear(fem, depth)};
    } catch (const fem::NoRoom&) {
      if (fem.given) throw;
      depth *= deeper;
    }
  }
  throw fem::SolverError(fmt::format("the stick radius under wear does not settle in {} runs", most_passes));
}

fem::WornProfile profile_before_wear(const FemCase& fem, const fem::Compliance& rings) {
  const Eigen::VectorXd unworn = fem::ring_means(rings, fem.profile);
  fem::WornProfile profile{unworn, Eigen::VectorXd::Zero(unworn.size())};
  if (const auto& before = fem.worn_before) profile.worn = fem::ring_means(rings, before->depth, before->kinks);
  return profile;
}

fem::WearCourse worn_to_its_end(std::unique_ptr<fem::RubbingContact> contact, const fem::WornProfile& profile,
                                const FemCase& fem, const Case::WearKinetics& wear,
                                const std::filesystem::path& checkpoints,
                                const std::function<void(const fem::WearCourse&)>& after_jump) {
  constexpr double nothing = 1e-6;
  const auto law = law_in(fem.units, wear, fem.friction_coefficient);
  const fem::WearControl control{wear.n_cycles.value_or(std::numeric_limits<double>::infinity()), wear.until,
                                 fem.resolution.wear_jump, nothing};
  const fem::WearState start{fem::WearingContact(std::move(contact), law)};
  WearCheckpoint checkpoint(checkpoints, description(fem, law, control, profile));
  auto state = checkpoint.restored(start).value_or(start);
  fem::wear_on(state, control, [&](const fem::WearState& now) {
    checkpoint.keep(now);
    after_jump(now.course);
  });
  return std::move(state.course);
}

}  // namespace fretval
