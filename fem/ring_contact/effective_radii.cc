#include "fem/ring_contact/effective_radii.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fem/ring_contact/stencil.h"
#include "fem/ring_contact/wider_rings.h"

namespace fretval::fem {
namespace {

bool has_equal_rings(const Compliance& compliance) {
  const auto& radii = compliance.radii;
  for (std::size_t m = 1; m < radii.size(); ++m)
    if (std::abs(radii[m] - radii[m - 1] - radii[1]) > 1e-9 * radii[1]) return false;
  return true;
}

/// Rows of the middle half of the discs 0..n, without the innermost ones, which have too few rings.
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

/// By how much more than on a half-space all of the surface moves per force, in a body with a far boundary; negative
/// where that is held. It is fitted by r^2/F = (r + beta h + gamma h^2/r)/E + offset r^2.
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

/// Radius of m equal rings over their width, m + beta + gamma/m + ... with so many terms, fitted to the forces of
/// discs. The disc of a single ring, and the outermost ones, next to which elements are no longer equal, are left out.
struct EdgeLaw {
  static constexpr Eigen::Index innermost = 2, outermost = 2;
  Eigen::VectorXd coefficients;
  double force_per_radius, misfit;

  /// per_radius: the force per radius where it is known from elsewhere.
  EdgeLaw(const Eigen::VectorXd& force, Eigen::Index n_terms, std::optional<double> per_radius = std::nullopt) {
    const Eigen::Index n = force.size() - innermost - outermost;
    Eigen::MatrixXd powers(n, n_terms);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n_terms; ++k)
        powers(i, k) = std::pow(static_cast<double>(innermost + i), static_cast<double>(1 - k));
    const Eigen::VectorXd known = force.segment(innermost, n);
    Eigen::VectorXd fit(n_terms);
    if (per_radius)
      fit << *per_radius,
          powers.rightCols(n_terms - 1).colPivHouseholderQr().solve(known - *per_radius * powers.col(0));
    else
      fit = powers.colPivHouseholderQr().solve(known);
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

/// Effective radii of a body, and the force per radius of the half-space from which they are taken.
struct KnownRadii {
  EffectiveRadii radii;
  double force_per_radius;
};

/// Radii of equal rings by the law that is fitted to the half-space. Their error is the difference from the law with
/// one term less.
KnownRadii by_law(const Compliance& half_space, const Compliance& compliance,
                  std::optional<double> force_per_radius = std::nullopt) {
  const Eigen::VectorXd force = punch_forces(half_space);
  const double ring = half_space.radii[1], width = compliance.radii[1];
  if (force_per_radius) *force_per_radius *= ring;
  const EdgeLaw law(force, 5, force_per_radius), shorter(force, 4, force_per_radius);
  const Eigen::Index n = compliance.areas.size();
  EffectiveRadii radii{Eigen::VectorXd::Zero(n + 1), {}, law.misfit * width, 0};
  for (Eigen::Index m = 1; m <= n; ++m)
    radii.radius[m] = width * (m < law.innermost ? force[m] / law.force_per_radius : law(static_cast<double>(m)));
  radii.calibration = radii.scatter + width * std::abs(law.coefficients[1] - shorter.coefficients[1]);
  return {radii, law.force_per_radius / ring};
}

/// Radii of a half-space, from the forces of its discs. force_per_radius: where it is known from elsewhere.
KnownRadii of_half_space(const Compliance& compliance, std::optional<double> force_per_radius = std::nullopt) {
  Eigen::VectorXd force = punch_forces(compliance);
  const Eigen::MatrixXd terms = terms_of_radius(compliance);
  const double offset = far_offset(terms, force);
  if (offset != 0) force.array() /= 1 - offset * force.array();
  const Eigen::VectorXd fit = fit_to_middle(terms, force);
  const double scatter = middle_of(terms * fit - force).cwiseAbs().maxCoeff() / fit[0],
               per_radius = force_per_radius.value_or(fit[0]);
  const Eigen::Index n = force.size() - 1;
  const Eigen::VectorXd radius = force / per_radius;
  return {{radius, (radius.head(n) + radius.tail(n)) / 2, scatter, 0}, per_radius};
}

/// Radii of a body that are taken over from a half-space with as many rings; or with fewer, where rings are equal,
/// whose fit is carried on to the others.
KnownRadii taken_over(const Compliance& half_space, const Compliance& compliance,
                      std::optional<double> force_per_radius = std::nullopt) {
  const auto known = of_half_space(half_space, force_per_radius);
  const auto& of_known = known.radii.radius;
  const Eigen::Index n = compliance.areas.size(), n_known = std::min<Eigen::Index>(n, half_space.areas.size());
  EffectiveRadii radii{Eigen::VectorXd(n + 1), {}, known.radii.scatter, 0};
  radii.radius.head(n_known + 1) = of_known.head(n_known + 1);
  if (n_known == n) return {radii, known.force_per_radius};
  const Eigen::MatrixXd terms = terms_of_radius(half_space);
  const Eigen::VectorXd fit = fit_to_middle(terms.rightCols(terms.cols() - 1), of_known - terms.col(0));
  const Eigen::MatrixXd further = terms_of_radius(compliance);
  for (Eigen::Index m = n_known + 1; m <= n; ++m)
    radii.radius[m] = further(m, 0) + further.row(m).segment(1, fit.size()).dot(fit);
  return {radii, known.force_per_radius};
}

/// Rings, and pairs of them, whose half-space has the same force per radius.
RadiiByWidth taken_over_by_width(const Compliance& compliance, const Compliance& wide) {
  // Enough for the five terms of the law; half as many wide rings are enough for the four that are left where the force
  // per radius is known.
  constexpr Eigen::Index enough_discs = 16;
  const auto &half_space = *compliance.half_space, &of_wide = *wide.half_space;
  const bool has_law =
      half_space.areas.size() >= enough_discs && has_equal_rings(half_space) && has_equal_rings(compliance);
  const auto rings = has_law ? by_law(half_space, compliance) : taken_over(half_space, compliance);
  const double k = rings.force_per_radius;
  return {rings.radii, (has_law ? by_law(of_wide, wide, k) : taken_over(of_wide, wide, k)).radii};
}

/// Discs of rings, or of wider rings, on a body that is no half-space.
struct Discs {
  const Compliance& compliance;
  EffectiveRadii& radii;
  Eigen::VectorXd force = punch_forces(compliance);
};

/// By how much further out than on a half-space the edges of discs lie, over the squares of the widths of their last
/// rings: at the effective radii of discs of wider rings.
struct FurtherOut {
  Eigen::VectorXd radius, per_square;

  /// Zero at the centre, where any body is a half-space.
  [[nodiscard]] double operator()(double at) const { return interpolated(radius, per_square, at); }
};

/// Found from the difference in force between discs of wider rings and discs of rings that are equally large by the
/// edges of a half-space.
FurtherOut further_out(const Discs& discs, const Discs& wide) {
  constexpr Eigen::Index innermost = 2, n_nodes = 6;
  const auto& rings = discs.compliance.radii;
  const Eigen::VectorXd& edges = discs.radii.radius;
  const Eigen::Index n = wide.force.size() - innermost;
  FurtherOut found{Eigen::VectorXd::Zero(n + 1), Eigen::VectorXd::Zero(n + 1)};
  for (Eigen::Index i = 1; i <= n; ++i) {
    const Eigen::Index j = innermost + i - 1, m = 2 * j;
    const double width = rings[m] - rings[m - 1], wider = rings[m] - rings[m - 2];
    const Stencil of_rings{edges, discs.force,
                           std::min(std::max<Eigen::Index>(m - n_nodes / 2, 1), edges.size() - n_nodes), n_nodes};
    const double at = wide.radii.radius[j], slope = (of_rings(at + width / 2) - of_rings(at - width / 2)) / width;
    found.radius[i] = at;
    found.per_square[i] = (wide.force[j] - of_rings(at)) / (slope * (wider * wider - width * width));
  }
  return found;
}

void move_out(const FurtherOut& further, Discs& discs) {
  const auto& rings = discs.compliance.radii;
  auto& radius = discs.radii.radius;
  for (Eigen::Index m = 1; m < radius.size(); ++m) {
    const double width = rings[m] - rings[m - 1];
    radius[m] += width * width * further(radius[m]);
  }
}

/// Sets of_rings. The radius at which the force of a punch is the mean of those of the discs on either side of a ring
/// lies h^2 F''/(8 F') beyond the middle; a third of that shift is taken.
void find_of_rings(Discs& discs) {
  const auto& radius = discs.radii.radius;
  const Eigen::Index n = radius.size() - 1;
  const Eigen::VectorXd force = (discs.force.head(n) + discs.force.tail(n)) / 2;
  Eigen::VectorXd& of_rings = discs.radii.of_rings = (radius.head(n) + radius.tail(n)) / 2;
  for (Eigen::Index m = 1; m < n; ++m) of_rings[m] += (interpolated(discs.force, radius, force[m]) - of_rings[m]) / 3;
}

}  // namespace

RadiiByWidth effective_radii(const Compliance& compliance, const Compliance& wide) {
  if (!compliance.half_space) return {of_half_space(compliance).radii, of_half_space(wide).radii};
  auto radii = taken_over_by_width(compliance, wide);
  std::array discs{Discs{compliance, radii.rings}, Discs{wide, radii.wide}};
  constexpr Eigen::Index fewest_wide_rings = 4;
  if (wide.areas.size() >= fewest_wide_rings) {
    const auto further = further_out(discs[0], discs[1]);
    constexpr double gain = 3;  // of a second order
    const double calibration = (radii.rings.calibration + radii.wide.calibration) / gain;
    for (auto& one : discs) {
      move_out(further, one);
      one.radii.calibration += calibration;
    }
  }
  for (auto& one : discs) find_of_rings(one);
  return radii;
}

EffectiveRadii effective_radii(const Compliance& compliance) {
  if (!compliance.half_space) return of_half_space(compliance).radii;
  return effective_radii(compliance, with_wider_rings(compliance)).rings;
}

}  // namespace fretval::fem
