#include "mdr/springs/path_response.h"

#include <algorithm>
#include <cmath>

#include "mdr/motion/force_control.h"
#include "mdr/springs/force_balance.h"
#include "mdr/springs/path_history.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/springs/spring_history.h"
#include "mdr/springs/spring_stick.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

class IndependentAlongPath {
 public:
  IndependentAlongPath(SpringBed bed, const PronyBody& body, double mu, const SampledPath& path)
      : bed_(std::move(bed)), axis_weights_(axis_weights(bed_)), body_(body), mu_(mu), path_(path) {}

  void add_piece(double dt) { steps_.emplace_back(body_, mu_, dt); }
  [[nodiscard]] SpringState start(const PathRest& rest) const {
    return relaxed_state(bed_, body_, path_.normal_force ? relaxed_indentation(bed_, body_, rest.normal) : rest.normal);
  }
  void advance(SpringState& state, std::size_t piece, const PrescribedInStep& prescribed) const {
    const auto& step = steps_[piece];
    step.advance(state, bed_, path_.has_forces() ? balanced(step, state, bed_, prescribed) : prescribed.indenter);
  }
  [[nodiscard]] double normal_scale() const { return mdr::normal_scale(body_); }
  [[nodiscard]] double tangential_scale() const { return mdr::tangential_scale(body_); }
  [[nodiscard]] double friction_limit() const { return 1.5 * mu_; }
  [[nodiscard]] const SpringBed& bed() const { return bed_; }
  [[nodiscard]] SpringForces forces(const SpringState& state) const {
    return forces_of_springs(bed_, body_, axis_weights_, state, by_force());
  }
  [[nodiscard]] Dissipation heat(double dt, const SpringState& before, const SpringState& after) const {
    return dissipation(widths_in_step(bed_, body_, before, after, by_force()), body_, mu_, dt, before, after);
  }
  [[nodiscard]] double stick_depth(const Eigen::ArrayXd& margin, const SlipOfSprings& slip) const {
    return mdr::stick_depth(bed_, mu_, margin, slip);
  }

 private:
  [[nodiscard]] ByForce by_force() const { return {path_.normal_force, path_.tangential_force}; }

  SpringBed bed_;
  Eigen::ArrayXd axis_weights_;
  const PronyBody& body_;
  double mu_;
  const SampledPath& path_;
  std::vector<SpringStep> steps_;  // by piece
};

}  // namespace

PathCourse path_course(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                       const PathFineness& fineness) {
  validate_along_path(path, fineness);
  // No spring beyond: with a dashpot one that touches halfway would carry its jump of load over its whole width.
  const double outer = inverse_transform(profile, deepest_indentation(profile, body, path));
  IndependentAlongPath springs(spring_bed(profile, outer, fineness.n_springs), body, mu, path);
  return PathHistory<IndependentAlongPath>(std::move(springs), body, mu, path, fineness).run();
}

double deepest_indentation(const Profile& profile, const PronyBody& body, const SampledPath& path) {
  const double most = maximum_normal(path);
  return path.normal_force ? indentation_for_force(profile, body.relaxed_modulus, most) : most;
}

SteppedPathForces path_forces(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                              const PathFineness& coarse) {
  return extrapolated_path_forces(
      body, path, coarse, [&](const PathFineness& fineness) { return path_course(profile, body, mu, path, fineness); });
}

}  // namespace fretval::mdr
