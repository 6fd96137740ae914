#pragma once

#include <Eigen/Dense>
#include <limits>
#include <vector>

#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr {

/// Largest change of a traction between two states, over the largest traction of the first one.
double change_of_tractions(const SpringState& before, const SpringState& after, double mu);

/// The periodicity for histories of n and 2 n springs (fineness 1 and 2) that are extrapolated. With a dashpot slip
/// dies out like a power of the periods, changes about like their cube (7, 10, 17, 29 periods for 1e-2 to 1e-5): so the
/// periodicity is at least 1e-4, and a sixteenth of that for the finer one: what is still to come then is part of their
/// difference.
double periodicity_of(const PronyBody& body, double periodicity, int fineness);

/// Tells when tractions repeat from period to period: when they change by no more than a periodicity. With a dashpot
/// the load of a spring that touches jumps, and under a normal force the spring that touches last may differ from
/// period to period, so that changes may stay above any periodicity: there changes below 1e-2 that have not fallen for
/// 10 periods count as repetition.
class Repetition {
 public:
  Repetition(const PronyBody& body, double periodicity) : jumps_(body.viscosity > 0), periodicity_(periodicity) {}

  /// change: of tractions in a period, one period after the other.
  bool reached(double change);

 private:
  bool jumps_;
  double periodicity_;
  double least_ = std::numeric_limits<double>::infinity();
  int periods_since_least_ = 0;
};

/// Whether the stick zone still grows from period to period: whether the innermost of the springs that slipped by more
/// than allowed in the last period slips ever less: more in one of the last ten periods at most, and less by a
/// hundredth at least over all of them. Under a body much stiffer in motion than at rest slip locks in little traction,
/// and dies out long after tractions seem to repeat.
bool still_settles(const std::vector<Eigen::ArrayXd>& slip_of_periods, double allowed);

}  // namespace fretval::mdr
