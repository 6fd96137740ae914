#pragma once

#include <string>

#include "fem/condensation/operator_file.h"

namespace fretval {

/// An operator of so many rings that no body has.
inline fem::StoredOperator made_up_operator(const std::string& key, Eigen::Index n = 8) {
  fem::StoredOperator stored{key, {}, {{"dofs", 7}}};
  for (Eigen::Index i = 0; i <= n; ++i) stored.compliance.radii.push_back(static_cast<double>(i));
  stored.compliance.areas = Eigen::VectorXd::LinSpaced(n, 1, 2);
  stored.compliance.matrix = Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n));
  return stored;
}

}  // namespace fretval
