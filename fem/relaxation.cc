#include "fem/relaxation.h"

#include <cmath>

namespace fretval::fem {
namespace {

/// `m_k = int_0^1 exp(-z (1-x)) x^k dx`, k = 0, 1, 2, by the recurrence `m_k = (1 - k m_{k-1}) / z`; for small z it cancels,
/// and the series `m_k = sum_j (-z)^j k! / (k+j+1)!` takes over.
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

}  // namespace

RelaxationStep::RelaxationStep(const RelaxationModel& model, double dt)
    : model_(model), dt_(dt), instantaneous_(model.relaxed + model.viscosity / dt) {
  for (std::size_t i = 0; i < model.moduli.size(); ++i) {
    const double z = dt / model.times[i];
    const auto [m0, m1, m2] = exponential_moments(z);
    decay_.push_back(std::exp(-z));
    gain_.push_back(model.moduli[i] * m0);
    instantaneous_ += gain_.back();
    const double scale = model.moduli[i] * dt;
    weights_.push_back({scale * (m0 - 3 * m1 + 2 * m2), scale * (4 * m1 - 4 * m2), scale * (2 * m2 - m1)});
  }
}

double RelaxationStep::memory_increment(std::size_t branch, const StepRates& rates) const {
  const auto& w = weights_[branch];
  return w[0] * rates[0] + w[1] * rates[1] + w[2] * rates[2];
}

Eigen::VectorXd RelaxationStep::response_without_slip(const Eigen::VectorXd& displacement,
                                                      const Eigen::MatrixXd& memory, double indenter_increment,
                                                      const StepRates& rates) const {
  double common = model_.relaxed * indenter_increment + model_.viscosity * rates[2];
  for (std::size_t i = 0; i < decay_.size(); ++i) common += memory_increment(i, rates);
  Eigen::VectorXd response = (model_.relaxed * displacement).array() + common;
  for (std::size_t i = 0; i < decay_.size(); ++i) response += decay_[i] * memory.col(static_cast<Eigen::Index>(i));
  return response;
}

void RelaxationStep::advance(Eigen::VectorXd& displacement, Eigen::MatrixXd& memory, double indenter_increment,
                             const StepRates& rates, const Eigen::VectorXd& slip) const {
  displacement.array() += indenter_increment - slip.array();
  for (std::size_t i = 0; i < decay_.size(); ++i) {
    auto h = memory.col(static_cast<Eigen::Index>(i));
    h = (decay_[i] * h - gain_[i] * slip).array() + memory_increment(i, rates);
  }
}

}  // namespace fretval::fem
