#include "mdr/layer/mode_equations.h"

namespace fretval::mdr {

ModeEquations::ModeEquations(const LayerModes& modes) : modes_(modes) {}

void ModeEquations::take(const Eigen::ArrayXd& give) {
  if (factored_give_.size() == 0) return factor(give);
  changed_.clear();
  for (Eigen::Index j = 0; j < give.size(); ++j)
    if (give[j] != factored_give_[j]) changed_.push_back(j);
  // A third of the modes: about as many operations as factoring anew.
  if (3 * static_cast<Eigen::Index>(changed_.size()) > modes_.strength.size()) return factor(give);
  if (!changed_.empty()) correct(give);
}

void ModeEquations::factor(const Eigen::ArrayXd& give) {
  const Eigen::Index n = modes_.strength.size();
  changed_.clear();
  factored_give_ = give;
  factors_.compute(Eigen::MatrixXd::Identity(n, n) + modes_.response(give));
  answers_.resize(n, give.size());
  has_answer_.assign(static_cast<std::size_t>(give.size()), false);
}

void ModeEquations::correct(const Eigen::ArrayXd& give) {
  const auto n = static_cast<Eigen::Index>(changed_.size());
  change_.resize(n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index j = changed_[static_cast<std::size_t>(k)];
    change_[k] = give[j] - factored_give_[j];
    if (auto&& known = has_answer_[static_cast<std::size_t>(j)]; !known) {
      answers_.col(j) = factors_.solve(modes_.at_springs.col(j));
      known = true;
    }
  }
  for (Eigen::Index k = 0; k < n; ++k)
    matrix.col(k).array() += change_ * pulled_at_changed(answers_.col(changed_[static_cast<std::size_t>(k)])).array();
  correction_.compute(matrix);
}

Eigen::VectorXd ModeEquations::pulled_at_changed(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd weighted = (modes_.strength * x.array()).matrix();
  Eigen::VectorXd pulled(changed_.size());
  for (std::size_t k = 0; k < changed_.size(); ++k)
    pulled[static_cast<Eigen::Index>(k)] = modes_.at_springs.col(changed_[k]).dot(weighted);
  return pulled;
}

Eigen::VectorXd ModeEquations::solve(const Eigen::VectorXd& rest) const {
  if (rest.size() == 0) return rest;
  Eigen::VectorXd x = factors_.solve(rest);
  if (changed_.empty()) return x;
  const Eigen::VectorXd by_changed = correction_.solve((change_ * pulled_at_changed(x).array()).matrix());
  for (std::size_t k = 0; k < changed_.size(); ++k)
    x -= by_changed[static_cast<Eigen::Index>(k)] * answers_.col(changed_[k]);
  return x;
}

}  // namespace fretval::mdr
