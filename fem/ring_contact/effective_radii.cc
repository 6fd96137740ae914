#include "fem/ring_contact/effective_radii.h"

#include <algorithm>
#include <cmath>

namespace fretval::fem {
namespace {

bool has_equal_rings(const Compliance& compliance) {
  const auto& radii = compliance.radii;
  for (std::size_t m = 1; m < radii.size(); ++m)
    if (std::abs(radii[m] - radii[m - 1] - radii[1]) > 1e-9 * radii[1]) return false;
  return true;
}

/// What is known of discs 0..n, without the innermost ones, which are of too few rings.
template <class Rows>
auto middle_of(const Rows& discs) {
  const Eigen::Index n = discs.rows() - 1;
  return discs.middleRows(n / 4, std::max<Eigen::Index>(n / 2, 3));
}

Eigen::VectorXd fit_to_middle(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values) {
  return middle_of(terms).colPivHouseholderQr().solve(Eigen::VectorXd(middle_of(values)));
}

/// r, h and h^2/r. Under rings that differ, the third term would fit their differences.
Eigen::MatrixXd terms_of_radius(const Compliance& compliance) {
  const Eigen::Index n = compliance.areas.size();
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(n + 1, 3);
  for (Eigen::Index m = 1; m <= n; ++m) {
    const double radius = compliance.radii[m], width = radius - compliance.radii[m - 1];
    terms.row(m) << radius, width, width * width / radius;
  }
  return terms.leftCols(has_equal_rings(compliance) ? 3 : 2);
}

/// How much further than that of a half-space all of the surface goes per force, in a body with a far boundary; less
/// than 0 where that is held. From r^2/F = (r + beta h + gamma h^2/r)/E + offset r^2.
double far_offset(const Eigen::MatrixXd& terms, const Eigen::VectorXd& force) {
  constexpr double of_half_space = 1e-3;  // more than the far part of our own coarse meshes puts in, up to 5e-4
  const Eigen::Index n = force.size() - 1, n_terms = terms.cols();
  if (middle_of(terms).rows() <= n_terms + 1) return 0;
  const Eigen::ArrayXd radius = terms.col(0);
  Eigen::MatrixXd with_offset(n + 1, n_terms + 1);
  with_offset << terms, radius.square();
  Eigen::VectorXd known = radius.square() / force.array();
  known[0] = 0;
  const Eigen::VectorXd fit = fit_to_middle(with_offset, known);
  const double offset = fit[n_terms], stiffening = std::abs(offset / fit[0]) * radius[n];
  const double left_out = std::pow(terms.col(1).maxCoeff() / radius[n], static_cast<double>(n_terms - 1));
  return stiffening > std::max(of_half_space, left_out) ? offset : 0;
}

/// Force of a unit indentation on rings 0..m-1, |L_m^{-1} A_m|^2: one forward substitution serves every m.
Eigen::VectorXd punch_forces(const Compliance& compliance) {
  const Eigen::Index n = compliance.areas.size();
  const Eigen::VectorXd half =
      cholesky_factor(compliance.matrix).triangularView<Eigen::Lower>().solve(compliance.areas);
  Eigen::VectorXd force(n + 1);
  force[0] = 0;
  for (Eigen::Index m = 1; m <= n; ++m) force[m] = force[m - 1] + half[m - 1] * half[m - 1];
  return force;
}

/// r_m of m equal rings over their width, m + beta + gamma/m + ... in terms, as the forces of discs have it. The disc
/// of a single ring, and the outermost ones, next to which elements are no longer equal, are left out.
struct EdgeLaw {
  static constexpr Eigen::Index innermost = 2, outermost = 2;
  Eigen::VectorXd coefficients;
  double force_per_radius, misfit;

  EdgeLaw(const Eigen::VectorXd& force, Eigen::Index n_terms) {
    const Eigen::Index n = force.size() - innermost - outermost;
    Eigen::MatrixXd powers(n, n_terms);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n_terms; ++k)
        powers(i, k) = std::pow(static_cast<double>(innermost + i), static_cast<double>(1 - k));
    const Eigen::VectorXd known = force.segment(innermost, n), fit = powers.colPivHouseholderQr().solve(known);
    coefficients = fit / fit[0];
    force_per_radius = fit[0];
    misfit = (powers * fit - known).cwiseAbs().maxCoeff() / fit[0];
  }

  [[nodiscard]] double operator()(double m) const {
    double radius = 0, power = m;
    for (const double coefficient : coefficients) {
      radius += coefficient * power;
      power /= m;
    }
    return radius;
  }
};

/// Enough discs for five terms.
constexpr Eigen::Index enough_discs = 16;

/// Of equal rings. Two laws, the second one with a term less, differ by what the further terms are worth.
EffectiveRadii by_law(const Compliance& half_space, const Compliance& compliance) {
  const Eigen::VectorXd force = punch_forces(half_space);
  const EdgeLaw law(force, 5), shorter(force, 4);
  const Eigen::Index n = compliance.areas.size();
  const double width = compliance.radii[1];
  EffectiveRadii radii{Eigen::VectorXd::Zero(n + 1), law.misfit * width, 0};
  for (Eigen::Index m = 1; m <= n; ++m)
    radii.radius[m] = width * (m < law.innermost ? force[m] / law.force_per_radius : law(static_cast<double>(m)));
  radii.calibration = radii.scatter + width * std::abs(law.coefficients[1] - shorter.coefficients[1]);
  return radii;
}

/// Of a body whose rings a half-space knows, which has as many or, of equal rings, fewer of them.
EffectiveRadii taken_over(const Compliance& half_space, const Compliance& compliance) {
  if (half_space.areas.size() >= enough_discs && has_equal_rings(half_space) && has_equal_rings(compliance))
    return by_law(half_space, compliance);
  const auto known = effective_radii(half_space);
  const Eigen::Index n = compliance.areas.size(), n_known = std::min<Eigen::Index>(n, half_space.areas.size());
  EffectiveRadii radii{Eigen::VectorXd(n + 1), known.scatter, 0};
  radii.radius.head(n_known + 1) = known.radius.head(n_known + 1);
  if (n_known == n) return radii;
  const Eigen::MatrixXd terms = terms_of_radius(half_space);
  const Eigen::VectorXd fit = fit_to_middle(terms.rightCols(terms.cols() - 1), known.radius - terms.col(0));
  const Eigen::MatrixXd further = terms_of_radius(compliance);
  for (Eigen::Index m = n_known + 1; m <= n; ++m)
    radii.radius[m] = further(m, 0) + further.row(m).segment(1, fit.size()).dot(fit);
  return radii;
}

}  // namespace

EffectiveRadii effective_radii(const Compliance& compliance) {
  if (compliance.half_space) return taken_over(*compliance.half_space, compliance);
  Eigen::VectorXd force = punch_forces(compliance);
  const Eigen::MatrixXd terms = terms_of_radius(compliance);
  const double offset = far_offset(terms, force);
  if (offset != 0) force.array() /= 1 - offset * force.array();
  const Eigen::VectorXd fit = fit_to_middle(terms, force);
  const double scatter = middle_of(terms * fit - force).cwiseAbs().maxCoeff() / fit[0];
  return {force / fit[0], scatter, 0};
}

}  // namespace fretval::fem
