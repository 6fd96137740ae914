#include "comparison/accuracy/tracks.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

constexpr Eigen::Index enough_stuck_rings = 6, enough_slipping_rings = 3;
constexpr double finest_ring_at_the_centre = 1e-4, finest_ring_at_the_edge = 1e-7;

/// The next power of two, so that similar cases share their bodies.
double rounded_up(double x) {
  return std::exp2(std::ceil(std::log2(x)));
}

double ring_of(const Resolution& resolution) {
  return resolution.focus ? resolution.focus->ring : 1.0 / resolution.elements_per_radius;
}

Eigen::Index rings_within(const std::vector<double>& radii, double c) {
  return std::max<Eigen::Index>(std::upper_bound(radii.begin(), radii.end(), c) - radii.begin() - 1, 0);
}

}  // namespace

std::vector<Resolution> Tracks::all() const {
  std::vector<Resolution> resolutions{base};
  for (const auto& [quantity, resolution] : focused) resolutions.push_back(resolution);
  return resolutions;
}

const Resolution& Tracks::of(Quantity quantity) const {
  const auto found = focused.find(quantity);
  return found == focused.end() ? base : found->second;
}

std::optional<Focus> closer_look(Quantity quantity, const Tracks& tracks, const Computations& computed,
                                 const Tolerances& tolerances) {
  const Resolution& now = tracks.of(quantity);
  const auto& fe = computed.at(now).fe;
  const auto& values = computed.quantities().at(now);
  const double c = values.at(quantity), ring = ring_of(now);
  const Eigen::Index n_stuck = rings_within(fe.body->radii, c);
  if (n_stuck < enough_stuck_rings) {
    // A zone that does not show needs no finer rings once it is known to be small against the tolerance.
    const double fine_enough = n_stuck > 0 ? 0 : tolerances.stick_radius / 4;
    if (ring < std::max(finest_ring_at_the_centre, fine_enough)) return std::nullopt;
    const double outer = n_stuck > 0 ? rounded_up(1.5 * c + ring) : rounded_up(ring);
    return Focus{0, outer, outer / 32};
  }
  const auto contact = values.find(Quantity::contact_radius_max);
  if (fe.rings.contact - n_stuck >= enough_slipping_rings || contact == values.end()) return std::nullopt;
  if (ring < finest_ring_at_the_edge) return std::nullopt;
  const double edge = contact->second, width = rounded_up(std::max(1.5 * (edge - c), ring / 4));
  // Similar cases share their bodies if the edge is where it is expected.
  const double centre = std::abs(edge - 1) < width / 8 ? 1 : edge;
  return Focus{centre - 2 * width, centre + width / 2, width / 16};
}

bool focus_on(Quantity quantity, double least_gain, const PreparedCase& prepared, const Computations& computed,
              Tracks& tracks) {
  const auto& motion = prepared.fem.motion;
  const bool nothing_moves = motion.normal.empty() && motion.tangential.empty() && !motion.path,  // and nothing slips
      is_asked_for = computed.quantities().at(tracks.of(quantity)).count(quantity) > 0;
  if (prepared.input.rings_per_radius || prepared.fem.given || prepared.fem.kind != ContactKind::discs ||
      nothing_moves || !is_asked_for)
    return false;
  const auto focus = closer_look(quantity, tracks, computed, prepared.tolerances);
  if (!focus || focus->ring > ring_of(tracks.of(quantity)) / least_gain) return false;
  Resolution closer = tracks.base;
  closer.focus = focus;
  tracks.focused[quantity] = closer;
  return true;
}

}  // namespace fretval
