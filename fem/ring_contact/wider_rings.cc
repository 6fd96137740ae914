#include "fem/ring_contact/wider_rings.h"

#include <memory>

namespace fretval::fem {

Eigen::MatrixXd sums_of_pairs(const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd sums(rows.rows() / 2, rows.cols());
  for (Eigen::Index i = 0; i < sums.rows(); ++i) sums.row(i) = rows.row(2 * i) + rows.row(2 * i + 1);
  return sums;
}

Compliance with_wider_rings(const Compliance& compliance) {
  Compliance wide{{},
                  sums_of_pairs(compliance.areas),
                  Eigen::MatrixXd(sums_of_pairs(sums_of_pairs(compliance.matrix).transpose()))};
  for (Eigen::Index i = 0; i <= wide.areas.size(); ++i)
    wide.radii.push_back(compliance.radii[static_cast<std::size_t>(2 * i)]);
  if (compliance.half_space)
    wide.half_space = std::make_shared<const Compliance>(with_wider_rings(*compliance.half_space));
  return wide;
}

}  // namespace fretval::fem
