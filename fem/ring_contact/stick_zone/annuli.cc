#include "fem/ring_contact/stick_zone/annuli.h"

#include <algorithm>

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Unit displacement of some rings, while the others are free: tractions of the former, displacements of all.
struct Punch {
  Eigen::VectorXd traction, displacement;
};

Punch punch_on(const Compliance& compliance, const std::vector<bool>& rings) {
  std::vector<Index> inside;
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (rings[i]) inside.push_back(static_cast<Index>(i));
  const auto& matrix = *compliance.matrix;
  const Eigen::VectorXd load = compliance.areas(inside);
  const Eigen::MatrixXd within = matrix(inside, inside);
  Punch punch{Eigen::VectorXd::Zero(matrix.rows()), {}};
  const Eigen::VectorXd traction = within.llt().solve(load);
  for (std::size_t k = 0; k < inside.size(); ++k) punch.traction[inside[k]] = traction[static_cast<Index>(k)];
  punch.displacement = (matrix * punch.traction).cwiseQuotient(compliance.areas);
  return punch;
}

/// An end of a zone: its last ring, and which way the next one lies.
struct End {
  Index ring;
  int outwards;  // 1 or -1
};

/// Radius of the end of a zone when a ring just comes to it.
double radius_at_event(const ContactProblem& problem, Index ring, int outwards) {
  const auto& radii = problem.compliance.radii;
  const auto i = static_cast<std::size_t>(ring);
  const double middle = (radii[i] + radii[i + 1]) / 2, beyond = problem.series.radii()[ring] - middle;
  return middle + outwards * beyond;
}

double end_of_contact(const ContactProblem& problem, const Punch& punch, const Eigen::VectorXd& pressure,
                      const Eigen::VectorXd& gap, const End& end) {
  const Index last = end.ring, next = last + end.outwards;
  const double since = pressure[last] / punch.traction[last], until = gap[next] / (1 - punch.displacement[next]);
  const double from = radius_at_event(problem, last, end.outwards), to = radius_at_event(problem, next, end.outwards);
  return from + (to - from) * since / (since + until);
}

double end_of_stick(const ContactProblem& problem, const Punch& punch, const Eigen::VectorXd& margin,
                    const std::vector<bool>& sticks, const End& end) {
  const Index last = end.ring, before = last - end.outwards;
  const auto& radii = problem.compliance.radii;
  const double edge = radii[static_cast<std::size_t>(end.outwards > 0 ? last + 1 : last)];
  if (before < 0 || !sticks[static_cast<std::size_t>(before)]) return edge;
  auto others = sticks;
  others[static_cast<std::size_t>(last)] = false;
  const Punch smaller = punch_on(problem.compliance, others);
  const double reserve = margin[last] / punch.traction[last],
               more = (margin[before] - reserve * punch.traction[before]) / smaller.traction[before];
  if (!(more > 0)) return edge;
  const double at = radius_at_event(problem, last, end.outwards),
               step = at - radius_at_event(problem, before, end.outwards);
  return at + step * std::min(reserve / more, 1.0);
}

}  // namespace

std::vector<RingRange> ranges_of(const std::vector<bool>& rings) {
  std::vector<RingRange> ranges;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto ring = static_cast<Index>(i);
    if (rings[i] && (i == 0 || !rings[i - 1])) ranges.push_back({ring, ring});
    if (rings[i]) ranges.back().end = ring + 1;
  }
  return ranges;
}

std::vector<Annulus> annuli_of(const std::vector<bool>& rings, const std::vector<double>& radii) {
  std::vector<Annulus> annuli;
  for (const auto& [begin, end] : ranges_of(rings))
    annuli.push_back({radii[static_cast<std::size_t>(begin)], radii[static_cast<std::size_t>(end)]});
  return annuli;
}

std::vector<Annulus> contact_annuli(const ContactProblem& problem, const Eigen::VectorXd& pressure,
                                    const Eigen::VectorXd& gap) {
  std::vector<bool> touches(static_cast<std::size_t>(pressure.size()));
  for (Index i = 0; i < pressure.size(); ++i) touches[static_cast<std::size_t>(i)] = pressure[i] > 0;
  auto annuli = annuli_of(touches, problem.compliance.radii);
  if (annuli.empty()) return annuli;
  const Punch punch = punch_on(problem.compliance, touches);
  const auto ranges = ranges_of(touches);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [begin, end] = ranges[k];
    if (begin > 0) annuli[k].inner = end_of_contact(problem, punch, pressure, gap, {begin, -1});
    if (end < pressure.size()) annuli[k].outer = end_of_contact(problem, punch, pressure, gap, {end - 1, 1});
  }
  return annuli;
}

std::vector<Annulus> stick_annuli(const ContactProblem& tangential, const Eigen::VectorXd& margin,
                                  const std::vector<bool>& sticks) {
  auto annuli = annuli_of(sticks, tangential.compliance.radii);
  if (annuli.empty()) return annuli;
  const Punch punch = punch_on(tangential.compliance, sticks);
  const auto ranges = ranges_of(sticks);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [begin, end] = ranges[k];
    if (begin > 0) annuli[k].inner = end_of_stick(tangential, punch, margin, sticks, {begin, -1});
    annuli[k].outer = end_of_stick(tangential, punch, margin, sticks, {end - 1, 1});
  }
  return annuli;
}

}  // namespace fretval::fem
