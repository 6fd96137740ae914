#include "fem/ring_contact/stick_zone/touch_indentation.h"

namespace fretval::fem {

double touch_indentation(const Compliance& compliance, const Eigen::VectorXd& profile, Eigen::Index n_pressed,
                         Eigen::Index n_flank) {
  const Eigen::LLT<Eigen::MatrixXd> pressed(compliance.matrix->topLeftCorner(n_pressed, n_pressed));
  const Eigen::VectorXd areas = compliance.areas.head(n_pressed);
  const Eigen::MatrixXd coupling = compliance.matrix->block(n_pressed, 0, n_flank, n_pressed);
  const Eigen::VectorXd flank_areas = compliance.areas.segment(n_pressed, n_flank);
  const double closing = flank_areas.sum() - (coupling * pressed.solve(areas)).sum();
  const double height = flank_areas.dot(profile.segment(n_pressed, n_flank)) -
                        (coupling * pressed.solve(areas.cwiseProduct(profile.head(n_pressed)))).sum();
  return height / closing;
}

}  // namespace fretval::fem
