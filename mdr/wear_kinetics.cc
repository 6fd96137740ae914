#include "mdr/wear_kinetics.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/abel_matrices.h"
#include "mdr/checks.h"
#include "mdr/spring_energy.h"
#include "mdr/spring_history.h"
#include "mdr/spring_step.h"

namespace fretval::mdr {

namespace {
const double pi = std::acos(-1.0);
constexpr double growth = 1.3;  // of a jump over the one before

// The widest limiting profile, at c = 0, has f_inf = d_max beyond the axis.
double widest_worn_radius(const Profile& profile, double maximum_indentation) {
  double r = inverse_transform(profile, maximum_indentation);
  while (shape(profile, r) < maximum_indentation) r *= 1.02;
  return r;
}

// Wear of one cycle and the path of slip that made it, of the rings.
struct CycleWear {
  Eigen::ArrayXd depth;  // m
  Eigen::ArrayXd slip;   // m
  double friction_work = 0;
  double contact_radius = 0;
};

class WearingContact {
 public:
  WearingContact(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                 const WearControl& control)
      : body_(body),
        mu_(mu),
        motion_(motion),
        control_(control),
        dt_(1 / motion.normal_frequency / control.steps_per_cycle),
        path_(ramped_path(harmonic_motion(motion), n_ramp_cycles / motion.normal_frequency)),
        bed_(spring_bed(profile, 1.15 * widest_worn_radius(profile, maximum_indentation(motion)), control.n_springs)),
        unworn_depth_(bed_.depth),
        matrices_(abel_matrices(bed_)),
        step_(body, mu, dt_),
        springs_(relaxed_state(bed_, body, motion.indentation)),
        worn_(Eigen::ArrayXd::Zero(bed_.position.size())) {
    for (int k = 0; k < n_ramp_cycles; ++k) cycle();
  }

  // Lets the springs settle on the present profile, so that the slip which that takes is not wear of every cycle, and
  // measures a cycle.
  CycleWear settled_cycle() {
    for (int k = 0; k < most_settling_cycles; ++k) {
      const Eigen::ArrayXd before = springs_.tangential_load;
      for (int step = 1; step <= control_.steps_per_cycle; ++step) step_.advance(springs_, bed_, indenter(step));
      ++n_cycles_;
      if ((springs_.tangential_load - before).abs().maxCoeff() <= settled * mu_ * springs_.normal_load.maxCoeff())
        break;
    }
    return cycle();
  }

  // Wears the profile for n cycles like this one, less what the wear relieves the pressure by.
  void jump(const CycleWear& wear, double n) {
    const Eigen::MatrixXd& relief = relief_matrix(wear.contact_radius);
    const Eigen::VectorXd weight = (n * control_.wear_coefficient * wear.slip).matrix();
    Eigen::MatrixXd system = weight.asDiagonal() * relief;
    system.diagonal().array() += 1;
    worn_ += system.partialPivLu().solve((n * wear.depth).matrix()).array().max(0);
    bed_.depth = unworn_depth_ + (matrices_.image * worn_.matrix()).array();
  }

  [[nodiscard]] WearPoint point(double cycles, const CycleWear& wear) const {
    const Eigen::ArrayXd ring = 2 * pi * bed_.position * bed_.width[0];
    return {cycles, (ring * worn_).sum(), worn_.maxCoeff(), wear.friction_work, wear.contact_radius};
  }

  [[nodiscard]] bool at_end_of_springs(const CycleWear& wear) const {
    return wear.contact_radius > bed_.position[bed_.position.size() - 3];
  }

  [[nodiscard]] const Eigen::ArrayXd& radius() const { return bed_.position; }
  [[nodiscard]] const Eigen::ArrayXd& worn() const { return worn_; }

 private:
  static constexpr int n_ramp_cycles = 3;
  static constexpr int most_settling_cycles = 300;
  static constexpr double settled = 1e-8;  // change of the tractions in a cycle, over the largest

  CycleWear cycle() {
    CycleWear wear{Eigen::ArrayXd::Zero(worn_.size()), Eigen::ArrayXd::Zero(worn_.size())};
    Eigen::VectorXd pressure = surface_pressure();
    for (int k = 1; k <= control_.steps_per_cycle; ++k) {
      const SpringState before = springs_;
      step_.advance(springs_, bed_, indenter(k));
      const double shift = springs_.indenter.tangential - before.indenter.tangential;
      const Eigen::VectorXd move = (shift - (springs_.tangential_shift - before.tangential_shift)).matrix();
      const Eigen::VectorXd next = surface_pressure();
      const Eigen::ArrayXd path = (matrices_.displacement * move).array().abs();
      const Eigen::ArrayXd mean = (pressure + next).array() / 2;
      wear.depth += control_.wear_coefficient * mean * path;
      wear.slip += (mean > 0).select(path, 0.0);
      wear.friction_work += dissipation(bed_, body_, mu_, dt_, before, springs_).friction;
      wear.contact_radius = std::max(wear.contact_radius, contact_radius());
      pressure = next;
    }
    ++n_cycles_;
    return wear;
  }

  [[nodiscard]] IndenterState indenter(int step) const {
    return path_((n_cycles_ + static_cast<double>(step) / control_.steps_per_cycle) / motion_.normal_frequency);
  }

  [[nodiscard]] Eigen::VectorXd surface_pressure() const {
    const double stiffness = 4 * body_.relaxed_modulus;
    return (stiffness * (matrices_.stress * springs_.normal_load.matrix())).cwiseMax(0);
  }

  [[nodiscard]] double contact_radius() const {
    Eigen::Index n = 0;
    while (n < bed_.depth.size() && springs_.normal_load[n] > 0) ++n;
    return static_cast<double>(n) * bed_.width[0];
  }

  // Fall of the surface pressure per worn depth, springs inside the contact.
  const Eigen::MatrixXd& relief_matrix(double contact_radius) {
    if (contact_radius != relief_radius_) {
      const Eigen::VectorXd inside = (bed_.position < contact_radius).cast<double>().matrix();
      relief_ = 4 * body_.relaxed_modulus * (matrices_.stress * inside.asDiagonal() * matrices_.image);
      relief_radius_ = contact_radius;
    }
    return relief_;
  }

  const PronyBody& body_;
  double mu_;
  Motion motion_;
  const WearControl& control_;
  double dt_;
  IndenterPath path_;
  SpringBed bed_;
  Eigen::ArrayXd unworn_depth_;
  AbelMatrices matrices_;
  SpringStep step_;
  SpringState springs_;
  Eigen::ArrayXd worn_;
  Eigen::MatrixXd relief_;
  double relief_radius_ = -1;
  int n_cycles_ = 0;
};

void check(const Motion& motion, const WearControl& control) {
  validate(motion);
  require_non_negative("wear coefficient", control.wear_coefficient);
  require_non_negative("number of cycles", control.n_cycles);
  require_within("number of springs", static_cast<double>(control.n_springs), 10, 2000);
  require_within("steps per cycle", control.steps_per_cycle, 12, 1e5);
  require_within("largest jump", control.largest_jump, 1e-6, 1);
  if (!motion.phase || motion.normal_frequency != motion.tangential_frequency)
    throw std::invalid_argument("wear kinetics need equal frequencies and a locked phase");
}

}  // namespace

WearKinetics wear_kinetics(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                           const WearControl& control) {
  check(motion, control);
  WearingContact contact(profile, body, mu, motion, control);
  CycleWear wear = contact.settled_cycle();
  WearKinetics result;
  result.curve.push_back(contact.point(0, wear));
  const double largest = control.largest_jump * maximum_indentation(motion);
  double done = 0, last = std::numeric_limits<double>::infinity();
  while (done < control.n_cycles && !contact.at_end_of_springs(wear)) {
    const double fastest = wear.depth.maxCoeff();
    const double jump = std::min({control.n_cycles - done, growth * last, fastest > 0 ? largest / fastest : last});
    contact.jump(wear, jump);
    done += jump;
    last = jump;
    wear = contact.settled_cycle();
    result.curve.push_back(contact.point(done, wear));
  }
  result.radius = contact.radius();
  result.worn_depth = contact.worn();
  return result;
}

}  // namespace fretval::mdr
