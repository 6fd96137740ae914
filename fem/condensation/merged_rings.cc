#include "fem/condensation/merged_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace fretval::fem {

Compliance merged_rings(const Compliance& compliance, const std::vector<double>& radii) {
  const auto& fine = compliance.radii;
  if (radii.size() < 2 || radii.front() != fine.front() || radii.back() > fine.back() ||
      !std::includes(fine.begin(), fine.end(), radii.begin(), radii.end()))
    throw std::invalid_argument(
        fmt::format("{} wider rings: their radii must be some of those of the {} rings", radii.size(), fine.size()));
  const auto n = static_cast<Eigen::Index>(radii.size()) - 1, n_fine = compliance.areas.size(),
             n_components = compliance.matrix->rows() / n_fine;
  Eigen::MatrixXd members = Eigen::MatrixXd::Zero(n_components * n_fine, n_components * n);
  Eigen::Index wide = 0;
  for (Eigen::Index i = 0; i < n_fine && wide < n; ++i) {
    for (Eigen::Index k = 0; k < n_components; ++k) members(k * n_fine + i, k * n + wide) = 1;
    if (fine[static_cast<std::size_t>(i) + 1] == radii[static_cast<std::size_t>(wide) + 1]) ++wide;
  }
  Compliance merged{radii, members.topLeftCorner(n_fine, n).transpose() * compliance.areas,
                    SharedMatrix(Eigen::MatrixXd(members.transpose() * *compliance.matrix * members))};
  if (const auto& half_space = compliance.half_space) {
    std::vector<double> known;
    std::copy_if(radii.begin(), radii.end(), std::back_inserter(known),
                 [&](double radius) { return radius <= half_space->radii.back(); });
    merged.half_space = std::make_shared<const Compliance>(merged_rings(*half_space, known));
  }
  return merged;
}

}  // namespace fretval::fem
