#include "mdr/layer/layer_limiting_state.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <stdexcept>

#include "mdr/stick/stick_demands.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// The unworn contact and the punches of one radius, of which a worn contact is made.
struct Disc {
  LayerContact unworn;
  LayerPunch normal, tangential;

  Disc(const Profile& profile, const Layer& layer, double c)
      : unworn(layer_contact(profile, layer, c)),
        normal(layer_punch(layer, Direction::normal, c)),
        tangential(layer_punch(layer, Direction::tangential, c)) {}

  [[nodiscard]] double beta() const { return tangential.edge / normal.edge; }
};

class Rig {
 public:
  Rig(const Profile& profile, const Layer& layer, const Rheology& body, double mu, const FrettingControl& control,
      StickCriterion criterion)
      : profile_(profile),
        layer_(layer),
        mu_(mu),
        control_(control),
        criterion_(criterion),
        modulus_(relaxed_modulus(body)),
        normal_ratio_(complex_modulus_ratio(body, angular_frequency(control.normal_frequency))),
        tangential_ratio_(complex_modulus_ratio(body, angular_frequency(control.tangential_frequency))),
        phase_(control.phase) {
    if (!phase_) return;
    if (std::holds_alternative<IndentationControl>(control.normal)) *phase_ -= std::arg(normal_ratio_);
    if (std::holds_alternative<TangentialDisplacementControl>(control.tangential))
      *phase_ += std::arg(tangential_ratio_);
  }

  // Indentation less that which sticking within c needs, m.
  [[nodiscard]] double surplus(double c) const {
    const Disc disc(profile_, layer_, c);
    const double tangential = disc.beta() * shift(disc) / (mu_ * spring_modulus_ratio(layer_.poisson_ratio));
    const StickDemands demands =
        phase_ ? locked_demands(tangential, sway(disc), *phase_) : unlocked_demands(tangential, sway(disc));
    return indentation(disc) - disc.unworn.indentation -
           (criterion_ == StickCriterion::shakedown ? shakedown_demand(demands) : first_slip_demand(demands));
  }

  // Contact radius of the unworn indenter at rest, m.
  [[nodiscard]] double largest_radius() const {
    if (const auto* force = std::get_if<NormalForceControl>(&control_.normal))
      return layer_contact_under_force(profile_, layer_, modulus_, force->mean).contact_radius;
    return layer_contact_at_depth(profile_, layer_, std::get<IndentationControl>(control_.normal).mean).contact_radius;
  }

  [[nodiscard]] LimitingState state(double c) const {
    const Disc disc(profile_, layer_, c);
    const double stiffness = punch_stiffness(disc.normal, modulus_);
    const Motion motion{
        indentation(disc),         sway(disc) / std::abs(normal_ratio_), shift(disc) / std::abs(tangential_ratio_),
        control_.normal_frequency, control_.tangential_frequency,        phase_};
    return {c, motion, normal_force(disc.unworn, modulus_) + stiffness * (motion.indentation - disc.unworn.indentation),
            stiffness * sway(disc), punch_stiffness(disc.tangential, modulus_) * shift(disc)};
  }

 private:
  [[nodiscard]] double indentation(const Disc& disc) const {
    if (const auto* force = std::get_if<NormalForceControl>(&control_.normal))
      return disc.unworn.indentation +
             (force->mean - normal_force(disc.unworn, modulus_)) / punch_stiffness(disc.normal, modulus_);
    return std::get<IndentationControl>(control_.normal).mean;
  }

  // Amplitudes that a relaxed layer would need for the same forces.
  [[nodiscard]] double sway(const Disc& disc) const {
    if (const auto* force = std::get_if<NormalForceControl>(&control_.normal))
      return force->amplitude / punch_stiffness(disc.normal, modulus_);
    return std::abs(normal_ratio_) * std::get<IndentationControl>(control_.normal).amplitude;
  }
  [[nodiscard]] double shift(const Disc& disc) const {
    if (const auto* force = std::get_if<TangentialForceControl>(&control_.tangential))
      return force->amplitude / punch_stiffness(disc.tangential, modulus_);
    return std::abs(tangential_ratio_) * std::get<TangentialDisplacementControl>(control_.tangential).amplitude;
  }

  const Profile& profile_;
  const Layer& layer_;
  double mu_;
  const FrettingControl& control_;
  StickCriterion criterion_;
  double modulus_;
  std::complex<double> normal_ratio_, tangential_ratio_;
  std::optional<double> phase_;  // between the forces
};

}  // namespace

std::optional<LimitingState> layer_limiting_state(const Profile& profile, const Layer& layer, const Rheology& body,
                                                  double mu, const FrettingControl& control, StickCriterion criterion) {
  validate(mu, control);
  const Rig rig(profile, layer, body, mu, control, criterion);
  constexpr int n_steps = 64;
  const double largest = rig.largest_radius();
  if (rig.surplus(largest) >= 0) return rig.state(largest);
  double upper = largest;
  for (int k = n_steps - 1; k > 0; --k) {
    const double lower = largest * k / n_steps;
    if (rig.surplus(lower) >= 0) {
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve([&](double c) { return rig.surplus(c); }, lower, upper,
                                                             boost::math::tools::eps_tolerance<double>(45), iterations);
      return rig.state((bracket.first + bracket.second) / 2);
    }
    upper = lower;
  }
  return std::nullopt;
}

EdgeRatios edge_ratios(const Layer& layer, double radius) {
  const LayerPunch normal = layer_punch(layer, Direction::normal, radius),
                   tangential = layer_punch(layer, Direction::tangential, radius);
  const double beta = tangential.edge / normal.edge;
  return {beta, beta * normal.load / tangential.load};
}

}  // namespace fretval::mdr
