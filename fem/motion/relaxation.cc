#include "fem/motion/relaxation.h"

#include <cmath>

#include "fem/support/mean_decay.h"

namespace fretval::fem {

std::complex<double> stiffening_at(const RelaxationModel& relaxation, double omega) {
  std::complex<double> modulus(relaxation.relaxed, relaxation.viscosity * omega);
  for (std::size_t i = 0; i < relaxation.times.size(); ++i) {
    const std::complex<double> z(0, omega * relaxation.times[i]);
    modulus += relaxation.moduli[i] * z / (1.0 + z);
  }
  return modulus / relaxation.relaxed;
}

namespace {

/// `m_k = int_0^1 exp(-z (1-x)) x^k dx`, k = 0, 1, 2, by the recurrence `m_k = (1 - k m_{k-1}) / z`; for small z it
/// cancels, and the series `m_k = sum_j (-z)^j k! / (k+j+1)!` takes over.
std::array<double, 3> exponential_moments(double z) {
  if (z > 0.5) {
    const double m0 = -std::expm1(-z) / z, m1 = (1 - m0) / z;
    return {m0, m1, (1 - 2 * m1) / z};
  }
  std::array<double, 3> moments{};
  for (int k = 0; k < 3; ++k) {
    double term = 1.0 / (k + 1), sum = term;
    for (int j = 1; j < 20; ++j) sum += term *= -z / (k + j + 1);
    moments[static_cast<std::size_t>(k)] = sum;
  }
  return moments;
}

// A branch much faster than the step acts as a dashpot, one slower as a spring. z: step over its relaxation time.
double viscous_share(double z) {
  return std::exp(-1 / z);
}

double balance_fraction(const RelaxationModel& model, double dt) {
  double stiffness = model.relaxed, viscosity = model.viscosity;
  for (std::size_t i = 0; i < model.moduli.size(); ++i) {
    const double share = viscous_share(dt / model.times[i]);
    stiffness += (1 - share) * model.moduli[i];
    viscosity += share * model.moduli[i] * model.times[i];
  }
  if (viscosity == 0) return 1;
  const double z = dt * stiffness / viscosity;
  return z < 1e-3 ? 0.5 + z / 12 : -1 / std::expm1(-z) - 1 / z;
}

}  // namespace

IndenterMove indenter_move(const std::function<ValueAndRate(double)>& motion, double begin, double end) {
  const auto first = motion(begin), last = motion(end);
  return {last.value - first.value, {first.rate, motion((begin + end) / 2).rate, last.rate}};
}

IndenterMove steady_move(double increment, double duration) {
  const double rate = increment / duration;
  return {increment, {rate, rate, rate}};
}

PronyInterval::PronyInterval(const RelaxationModel& model, double duration) {
  for (std::size_t i = 0; i < model.moduli.size(); ++i) {
    const double z = duration / model.times[i];
    const auto [m0, m1, m2] = exponential_moments(z);
    modulus_.push_back(model.moduli[i]);
    rate_.push_back(z);
    decay_.push_back(std::exp(-z));
    gain_.push_back(model.moduli[i] * m0);
    const double scale = model.moduli[i] * duration;
    weights_.push_back({scale * (m0 - 3 * m1 + 2 * m2), scale * (4 * m1 - 4 * m2), scale * (2 * m2 - m1)});
  }
}

double PronyInterval::memory_of(std::size_t branch, const IndenterMove& move) const {
  const auto& w = weights_[branch];
  return w[0] * move.rates[0] + w[1] * move.rates[1] + w[2] * move.rates[2];
}

double PronyInterval::memory_of_turn(std::size_t branch, double share, double until) const {
  return (1 - viscous_share(rate_[branch])) * whole_memory_of_turn(branch, share, until);
}

double PronyInterval::passing_memory_of_turn(std::size_t branch, double share, double until) const {
  return viscous_share(rate_[branch]) * whole_memory_of_turn(branch, share, until);
}

double PronyInterval::whole_memory_of_turn(std::size_t branch, double share, double until) const {
  const double z = rate_[branch], modulus = modulus_[branch];
  if (until <= share) return modulus * until / share * mean_decay(z * until);
  const double after = until - share;
  return modulus * (std::exp(-z * after) * mean_decay(z * share) - after / (1 - share) * mean_decay(z * after));
}

RelaxationStep::RelaxationStep(const RelaxationModel& model, double dt)
    : model_(model),
      dt_(dt),
      fraction_(balance_fraction(model, dt)),
      to_balance_(model, fraction_ * dt),
      whole_(model, dt),
      instantaneous_(model.viscosity / dt),
      stiffness_before_balance_(model.relaxed) {
  for (std::size_t i = 0; i < whole_.n_branches(); ++i) stiffness_before_balance_ += to_balance_.gain(i);
  instantaneous_ += fraction_ * stiffness_before_balance_;
}

double RelaxationStep::response_to_turn(double share) const {
  const double distance = fraction_ <= share ? fraction_ / share : (1 - fraction_) / (1 - share);
  double response = model_.relaxed * distance;
  for (std::size_t i = 0; i < whole_.n_branches(); ++i) response += whole_.memory_of_turn(i, share, fraction_);
  return response;
}

double RelaxationStep::passing_response_to_turn(double share) const {
  const double rate = (fraction_ <= share ? 1 / share : -1 / (1 - share)) / dt_;
  double response = model_.viscosity * rate;
  for (std::size_t i = 0; i < whole_.n_branches(); ++i) response += whole_.passing_memory_of_turn(i, share, fraction_);
  return response;
}

double RelaxationStep::response_to(const IndenterMove& move) const {
  double response = model_.relaxed * move.increment + model_.viscosity * move.rates[2];
  for (std::size_t i = 0; i < to_balance_.n_branches(); ++i) response += to_balance_.memory_of(i, move);
  return response;
}

namespace {

/// common: the response of what is driven by 1. driven: a vector, or an expression of ones that nothing is stored for.
template <class Driven>
void add_up_response(const RingState& state, double relaxed, const PronyInterval& to_balance, double common,
                     const Driven& driven, Eigen::VectorXd& response) {
  response = relaxed * state.displacement + common * driven;
  for (std::size_t i = 0; i < to_balance.n_branches(); ++i)
    response += to_balance.decay(i) * state.memory.col(static_cast<Eigen::Index>(i));
}

template <class Driven>
void advance_by(const PronyInterval& whole, const IndenterMove& move, const Eigen::VectorXd& slip, const Driven& driven,
                RingState& state) {
  state.displacement += move.increment * driven - slip;
  for (std::size_t i = 0; i < whole.n_branches(); ++i) {
    auto h = state.memory.col(static_cast<Eigen::Index>(i));
    h = whole.decay(i) * h - whole.gain(i) * slip + whole.memory_of(i, move) * driven;
  }
}

}  // namespace

Eigen::VectorXd RelaxationStep::response_without_slip(const RingState& state, const IndenterMove& move) const {
  Eigen::VectorXd response;
  find_response_without_slip(state, move, response);
  return response;
}

void RelaxationStep::find_response_without_slip(const RingState& state, const IndenterMove& move,
                                                Eigen::VectorXd& response) const {
  add_up_response(state, model_.relaxed, to_balance_, response_to(move),
                  Eigen::VectorXd::Ones(state.displacement.size()), response);
}

Eigen::VectorXd RelaxationStep::response_without_slip(const RingState& state, const IndenterMove& move,
                                                      const Eigen::VectorXd& driven) const {
  Eigen::VectorXd response;
  add_up_response(state, model_.relaxed, to_balance_, response_to(move), driven, response);
  return response;
}

void RelaxationStep::advance(RingState& state, const IndenterMove& move, const Eigen::VectorXd& slip) const {
  advance_by(whole_, move, slip, Eigen::VectorXd::Ones(slip.size()), state);
}

void RelaxationStep::advance(RingState& state, const IndenterMove& move, const Eigen::VectorXd& slip,
                             const Eigen::VectorXd& driven) const {
  advance_by(whole_, move, slip, driven, state);
}

}  // namespace fretval::fem
