#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mdr/rheology/rheology.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

// A second way to the same spring: march branch forces with a fixed small step from the relaxed state at y, the motion
// linear in time over a step. The tip is the deeper of the indenter's face and where an unloaded tip would go.
// Exact for the branches, first order in the step at events and for the dashpot.
class MarchedSpring {
 public:
  MarchedSpring(const PronyBody& body, double y, int n_steps)
      : y_(y), step_(2 * pi / n_steps), depth_(std::max(y, 0.0)), forces_(body.branch_moduli.size(), 0) {
    stiffness_ = 1 + body.viscosity / body.relaxed_modulus / step_;
    memory_ = body.viscosity / body.relaxed_modulus / step_;
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      const double x = step_ / body.branch_times[i];
      decays_.push_back(std::exp(-x));
      gains_.push_back(-std::expm1(-x) / x * body.branch_moduli[i] / body.relaxed_modulus);
      stiffness_ += gains_.back();
      memory_ += gains_.back();
    }
  }

  // Moves to theta, one step after the last, and returns the force.
  double advance(double theta) {
    double carried = -memory_ * depth_;
    for (std::size_t i = 0; i < forces_.size(); ++i) carried += decays_[i] * forces_[i];
    const double depth = std::max(y_ + std::cos(theta), -carried / stiffness_);
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      forces_[i] = decays_[i] * forces_[i] + gains_[i] * (depth - depth_);
    }
    depth_ = depth;
    return std::max(0.0, stiffness_ * depth + carried);
  }

 private:
  double y_, step_, depth_, stiffness_, memory_;
  std::vector<double> forces_, decays_, gains_;
};

// Forces at theta = 2 pi k/n_steps, k = 1..n_steps, of the last of n_cycles cycles. omega = 1: times in radians.
inline std::vector<double> marched_cycle(const PronyBody& body, double y, int n_steps, int n_cycles) {
  MarchedSpring spring(body, y, n_steps);
  const double step = 2 * pi / n_steps;
  std::vector<double> forces(n_steps);
  // From the rest height upwards, a quarter of a cycle before the deepest position: nothing jumps.
  for (int k = -n_steps / 4 + 1; k <= 0; ++k) spring.advance(step * k);
  for (int cycle = 0; cycle < n_cycles; ++cycle) {
    for (int k = 1; k <= n_steps; ++k) forces[k - 1] = spring.advance(step * k);
  }
  return forces;
}

}  // namespace fretval::mdr
