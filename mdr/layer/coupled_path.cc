#include "mdr/layer/coupled_path.h"

#include <memory>
#include <stdexcept>

#include "mdr/layer/coupled_history.h"
#include "mdr/layer/coupled_step.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/springs/path_history.h"

namespace fretval::mdr {
namespace {

class CoupledAlongPath {
 public:
  CoupledAlongPath(const CoupledBed& bed, const PronyBody& body, double mu, const SampledPath& path)
      : bed_(bed), axis_weights_(axis_weights(bed.springs)), body_(body), mu_(mu), path_(path) {}

  void add_piece(double dt) { steps_.push_back(std::make_unique<CoupledStep>(bed_, body_, mu_, dt)); }
  [[nodiscard]] SpringState start(const PathRest& rest) const {
    return relaxed_state(bed_, body_,
                         path_.normal_force ? relaxed_indentation(bed_, rest.normal / normal_scale()) : rest.normal);
  }
  void advance(SpringState& state, std::size_t piece, const PrescribedInStep& prescribed) const {
    steps_[piece]->advance(state, prescribed);
  }
  [[nodiscard]] double normal_scale() const { return force_scale(bed_, body_, Direction::normal); }
  [[nodiscard]] double tangential_scale() const { return force_scale(bed_, body_, Direction::tangential); }
  [[nodiscard]] double friction_limit() const { return mu_ * spring_modulus_ratio(bed_.layer.poisson_ratio); }
  [[nodiscard]] const SpringBed& bed() const { return bed_.springs; }
  [[nodiscard]] SpringForces forces(const SpringState& state) const {
    return coupled_forces(bed_, body_, axis_weights_, state, {path_.normal_force, path_.tangential_force});
  }
  [[nodiscard]] Dissipation heat(double dt, const SpringState& before, const SpringState& after) const {
    return dissipation(bed_, body_, mu_, dt, before, after);
  }
  [[nodiscard]] double stick_depth(const Eigen::ArrayXd& margin, const SlipOfSprings& slip) const {
    return coupled_stick_depth(bed_.springs, friction_limit(), margin, slip.path[0] / slip.n_ways);
  }

 private:
  const CoupledBed& bed_;
  Eigen::ArrayXd axis_weights_;
  const PronyBody& body_;
  double mu_;
  const SampledPath& path_;
  std::vector<std::unique_ptr<CoupledStep>> steps_;  // by piece
};

// Radius up to which there are springs, with room for a contact whose rim has memory.
double largest_radius(const Profile& profile, const Layer& layer, const PronyBody& body, const SampledPath& path) {
  constexpr double room = 1.05;
  const double most = maximum_normal(path);
  const auto contact = path.normal_force ? layer_contact_under_force(profile, layer, body.relaxed_modulus, most)
                                         : layer_contact_at_depth(profile, layer, most);
  return std::min(room * contact.contact_radius, end_radius(profile));
}

}  // namespace

SteppedPathForces coupled_path_forces(const Profile& profile, const Layer& layer, const PronyBody& body, double mu,
                                      const SampledPath& path, const PathFineness& coarse) {
  validate_along_path(path, coarse);
  const double outer = largest_radius(profile, layer, body, path);
  return extrapolated_path_forces(body, path, coarse, [&](const PathFineness& fineness) {
    const auto bed = coupled_bed(spring_bed(profile, outer, fineness.n_springs), layer);
    auto course = PathHistory<CoupledAlongPath>({bed, body, mu, path}, body, mu, path, fineness).run();
    if (course.history.deepest.normal_load[fineness.n_springs - 1] > 0)
      throw std::runtime_error("the contact reaches the end of the coupled springs");
    return course;
  });
}

}  // namespace fretval::mdr
