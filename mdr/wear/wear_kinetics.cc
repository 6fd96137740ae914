#include "mdr/wear/wear_kinetics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "mdr/springs/spring_history.h"
#include "mdr/support/checks.h"
#include "mdr/wear/abel_matrices.h"
#include "mdr/wear/wear_cycle.h"
#include "mdr/wear/wear_jump.h"

namespace fretval::mdr {

namespace {

constexpr double first_jump = 0.05;       // share of the largest
constexpr double growth_per_jump = 10.0;  // relative growth of a jump over the one before, over largest_jump
constexpr double hardly = 1e-9;           // share of the largest jump: jumps that wear less may double
constexpr double margin_of_springs = 1.05;

// The widest limiting profile, at c = 0, has f_inf = d_max beyond the axis.
double widest_worn_radius(const Profile& profile, double maximum_indentation) {
  double r = inverse_transform(profile, maximum_indentation);
  while (shape(profile, r) < maximum_indentation) r *= 1.02;
  return r;
}

// Springs with the edge of an interval at the stick radius, which a first history of the springs finds: wear leaves the
// springs inside it alone, so it does not move. The worn volume changes with the stick radius several times faster than
// in proportion, and would otherwise carry the error of half an interval.
SpringBed aligned_bed(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                      const WearControl& control) {
  const double outer = margin_of_springs * widest_worn_radius(profile, maximum_indentation(motion));
  SpringBed bed = spring_bed(profile, outer, control.n_springs);
  const double period = 1 / motion.normal_frequency;
  const HistoryControl history{period, control.steps_per_cycle, 3, 20000, 1e-8};
  const double depth =
      spring_history(bed, body, mu, {ramped_path(harmonic_motion(motion), 3 * period), {}, {}}, history)
          .depths.shakedown;
  if (depth <= 0) return bed;
  const double c = inverse_transform(profile, depth), inside = std::round(c / bed.width[0]);
  if (inside == 0) return bed;
  const double n_springs = std::ceil(outer * inside / c);
  return spring_bed(profile, n_springs * c / inside, static_cast<Eigen::Index>(n_springs));
}

// Worn depth of a jump to second order, from the depths of the jump made at once and in two halves, each of first order
// in the jump. A pressure that dies out as exp(-n) falls to 1/(1 + n) in a jump at once, so that for n > 2 + 2 sqrt(2)
// the extrapolation would wear off more than there is: rings of which the second half wears off less than 1/(2 +
// sqrt(2)) of what the first half does keep the sum of the halves.
Eigen::ArrayXd extrapolated(const Eigen::ArrayXd& at_once, const Eigen::ArrayXd& first, const Eigen::ArrayXd& second) {
  const double least = 1 / (2 + std::sqrt(2));
  return (second > least * first).select(2 * (first + second) - at_once, first + second).max(0);
}

class WearingContact {
 public:
  WearingContact(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                 const WearControl& control)
      : stiffness_(4 * body.relaxed_modulus * control.wear_coefficient),
        maximum_indentation_(maximum_indentation(motion)),
        largest_(control.largest_jump * maximum_indentation_),
        springs_(aligned_bed(profile, body, mu, motion, control), body, mu, motion, control.steps_per_cycle),
        unworn_depth_(springs_.bed().depth),
        matrices_(abel_matrices(springs_.bed())),
        worn_(Eigen::ArrayXd::Zero(unworn_depth_.size())),
        cycle_(springs_.settled_cycle(matrices_)) {}

  // Number of cycles that wear off a share of the largest jump at the present rate; infinite if nothing wears.
  [[nodiscard]] double cycles_of_jump(double share) const {
    const Eigen::MatrixXd load = cycle_.load.cwiseMax(0);
    const Eigen::VectorXd rate =
        stiffness_ * matrices_.stress.cwiseProduct(cycle_.path * load.transpose()).rowwise().sum();
    return share * largest_ / std::max(rate.maxCoeff(), 0.0);
  }

  struct Jump {
    double cycles;
    double share;  // of the largest jump, that was worn off
  };

  // Wears for n cycles, or fewer if that were more than the largest jump: at once and in two halves, both of first
  // order in n, and extrapolated to second.
  Jump jump(double n) {
    for (int trial = 0; trial < most_trials; ++trial) {
      const auto at_once = more_worn(n);
      const double most = at_once ? at_once->maxCoeff() : 2 * largest_;
      if (most > largest_) {
        n *= 0.9 * largest_ / most;
        continue;
      }
      const Eigen::ArrayXd before = worn_;
      const auto first = more_worn(n / 2);
      if (first) take_worn(before + *first);
      const auto second = first ? more_worn(n / 2) : std::nullopt;
      take_worn(second ? before + extrapolated(*at_once, *first, *second) : before);
      if (second) return {n, most / largest_};
      n /= 2;
    }
    throw std::runtime_error("no jump over cycles of wear is small enough for its equations to be solved");
  }

  [[nodiscard]] WearPoint point(double cycles) const {
    return {cycles,
            (matrices_.area * worn_).sum(),
            worn_.maxCoeff(),
            cycle_.friction_work,
            cycle_.contact_radius,
            cycle_.stick_radius};
  }

  [[nodiscard]] const Eigen::ArrayXd& radius() const { return springs_.bed().position; }
  [[nodiscard]] const Eigen::ArrayXd& worn() const { return worn_; }

 private:
  // Depth that wears off in n cycles more.
  [[nodiscard]] std::optional<Eigen::ArrayXd> more_worn(double n) const {
    return wear_jump(matrices_, cycle_, maximum_indentation_ - springs_.bed().depth, stiffness_ * n,
                     roundoff * maximum_indentation_);
  }

  void take_worn(const Eigen::ArrayXd& worn) {
    worn_ = worn;
    springs_.set_depth(unworn_depth_ + (matrices_.image * worn_.matrix()).array());
    cycle_ = springs_.settled_cycle(matrices_);
  }

  static constexpr int most_trials = 60;
  static constexpr double roundoff = 1e-13;

  double stiffness_;  // work of the wear jump per cycle
  double maximum_indentation_;
  double largest_;  // jump in m
  WearingSprings springs_;
  Eigen::ArrayXd unworn_depth_;
  AbelMatrices matrices_;
  Eigen::ArrayXd worn_;
  WearCycle cycle_;
};

void check(const Motion& motion, const WearControl& control) {
  validate(motion);
  require_non_negative("wear coefficient", control.wear_coefficient);
  require_non_negative("number of cycles", control.n_cycles);
  require_within("number of springs", static_cast<double>(control.n_springs), 10, 2000);
  require_within("steps per cycle", control.steps_per_cycle, 12, 1e5);
  require_within("largest jump", control.largest_jump, 1e-6, 1);
  double before = 0;
  for (const double cycles : control.snapshots) {
    require_within("cycles of a snapshot", cycles, before, control.n_cycles);
    before = cycles;
  }
  if (!motion.phase || motion.normal_frequency != motion.tangential_frequency)
    throw std::invalid_argument("wear kinetics need equal frequencies and a locked phase");
}

}  // namespace

WearKinetics wear_kinetics(const Profile& profile, const PronyBody& body, double mu, const Motion& motion,
                           const WearControl& control) {
  check(motion, control);
  WearingContact contact(profile, body, mu, motion, control);
  WearKinetics result;
  result.curve.push_back(contact.point(0));
  double done = 0, next = contact.cycles_of_jump(first_jump);
  const auto wear_until = [&](double stop) {
    while (done < stop) {
      const double asked = std::min(stop - done, next);
      const auto [cycles, share] = contact.jump(asked);
      done = cycles == stop - done ? stop : done + cycles;
      if (cycles < asked)
        next = cycles;
      else if (asked == next)
        next *= share < hardly ? 2 : 1 + growth_per_jump * control.largest_jump;
      result.curve.push_back(contact.point(done));
    }
  };
  for (const double cycles : control.snapshots) {
    wear_until(cycles);
    result.snapshots.push_back(contact.worn());
  }
  wear_until(control.n_cycles);
  result.radius = contact.radius();
  result.worn_depth = contact.worn();
  return result;
}

}  // namespace fretval::mdr
