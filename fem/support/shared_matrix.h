#pragma once

#include <Eigen/Dense>
#include <memory>
#include <utility>

namespace fretval::fem {

/// A dense matrix that does not change any more; copies share its numbers.
class SharedMatrix {
 public:
  SharedMatrix(Eigen::MatrixXd matrix = {}) : matrix_(std::make_shared<const Eigen::MatrixXd>(std::move(matrix))) {}
  operator const Eigen::MatrixXd&() const { return *matrix_; }
  const Eigen::MatrixXd& operator*() const { return *matrix_; }
  const Eigen::MatrixXd* operator->() const { return matrix_.get(); }

 private:
  std::shared_ptr<const Eigen::MatrixXd> matrix_;
};

}  // namespace fretval::fem
