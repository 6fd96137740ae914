#include "mdr/springs/spring_model.h"

#include <Eigen/SVD>
#include <cmath>
#include <complex>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// u of the unloaded spring as a row that acts on its free state; without a dashpot f = 0 gives it at once.
Eigen::RowVectorXd free_depth(const SpringModel& model) {
  const Eigen::Index n_depth = n_depth_states(model);
  Eigen::RowVectorXd depth = Eigen::RowVectorXd::Zero(n_depth + model.branch_moduli.size());
  if (n_depth == 1) {
    depth(0) = 1;
  } else {
    depth = (model.branch_moduli / (1 + model.branch_moduli.sum())).matrix().transpose();
  }
  return depth;
}

// B with |B s|^2/2 = (u^2 + sum gamma_i (u - v_i)^2)/2, the stored energy.
Eigen::MatrixXd energy_rows(const SpringModel& model, const Eigen::RowVectorXd& depth) {
  const Eigen::Index n_branches = model.branch_moduli.size();
  Eigen::MatrixXd rows(1 + n_branches, depth.size());
  rows.row(0) = depth;
  for (Eigen::Index i = 0; i < n_branches; ++i) {
    rows.row(1 + i) = depth;
    rows(1 + i, n_depth_states(model) + i) -= 1;
    rows.row(1 + i) *= std::sqrt(model.branch_moduli(i));
  }
  return rows;
}

FreeRecovery free_recovery(const SpringModel& model) {
  const Eigen::RowVectorXd depth = free_depth(model);
  if (depth.size() == 0) return {Eigen::ArrayXd(0), Eigen::MatrixXd(0, 0), Eigen::MatrixXd(0, 0), depth};
  Eigen::ArrayXd dissipation(depth.size());
  dissipation.tail(model.branch_moduli.size()) = model.branch_moduli * model.branch_times;
  if (n_depth_states(model) == 1) dissipation(0) = model.viscosity;
  const Eigen::VectorXd root = dissipation.sqrt().matrix();
  // Singular values of B C^(-1/2) instead of eigenvalues of C^(-1) B^T B: relaxation times many decades apart would
  // otherwise drown the slow rates in the roundoff of the fast ones.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(energy_rows(model, depth) * root.cwiseInverse().asDiagonal(),
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::MatrixXd from_modes = root.cwiseInverse().asDiagonal() * svd.matrixV();
  return {svd.singularValues().array().square(), svd.matrixV().transpose() * root.asDiagonal(), from_modes,
          depth * from_modes};
}

}  // namespace

SpringModel spring_model(const PronyBody& body, double omega) {
  require_positive("angular frequency", omega);
  const std::complex<double> modulus = complex_modulus(body, omega) / body.relaxed_modulus;
  const auto n_branches = static_cast<Eigen::Index>(body.branch_moduli.size());
  SpringModel model;
  model.branch_moduli = Eigen::Map<const Eigen::ArrayXd>(body.branch_moduli.data(), n_branches) / body.relaxed_modulus;
  model.branch_times = Eigen::Map<const Eigen::ArrayXd>(body.branch_times.data(), n_branches) * omega;
  model.viscosity = omega * body.viscosity / body.relaxed_modulus;
  model.storage = modulus.real();
  model.loss = modulus.imag();
  model.recovery = free_recovery(model);
  return model;
}

Eigen::Index n_depth_states(const SpringModel& model) {
  return model.viscosity > 0 ? 1 : 0;
}

Eigen::ArrayXd harmonic_branch_depths(const SpringModel& model, double y, double theta) {
  const Eigen::ArrayXd& T = model.branch_times;
  return y + (std::cos(theta) + T * std::sin(theta)) / (1 + T.square());
}

double harmonic_force(const SpringModel& model, double y, double theta) {
  return y + model.storage * std::cos(theta) - model.loss * std::sin(theta);
}

}  // namespace fretval::mdr
