#include "comparison/economy.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

std::bitset<n_coarsenings> refused_from_the_start(const FixedByCase& fixed) {
  std::bitset<n_coarsenings> refused;
  const auto refuse = [&](Coarsening step) { refused.set(static_cast<std::size_t>(step)); };
  if (fixed.rings) {
    refuse(Coarsening::half_the_rings);
    refuse(Coarsening::three_quarters_of_the_rings);
  }
  if (fixed.steps) {
    refuse(Coarsening::half_the_steps);
    refuse(Coarsening::three_quarters_of_the_steps);
  }
  return refused;
}

}  // namespace

bool covers(const ProvedMeasures& proved, const Measures& measures) {
  return std::all_of(proved.begin(), proved.end(), [&](const auto& entry) {
    const auto& [quantity, p] = entry;
    const auto found = measures.find(quantity);
    return found != measures.end() && std::abs(found->second - p.value) + p.bar <= p.tolerance;
  });
}

Economy::Economy(const std::vector<ProvedTrack>& tracks, const SceneNeeds& needs, const FixedByCase& fixed)
    : needs_(needs) {
  for (const auto& track : tracks) paths_.push_back({track, refused_from_the_start(fixed)});
}

std::optional<Resolution> Economy::advance(Path& path, const std::map<Resolution, Measures>& known) const {
  for (std::size_t step = 0; step < n_coarsenings; ++step)
    while (!path.refused.test(step)) {
      const auto candidate = coarsened(path.track.resolution, static_cast<Coarsening>(step), needs_);
      if (candidate) {
        const auto found = known.find(*candidate);
        if (found == known.end()) return candidate;
        if (covers(path.track.measures, found->second)) {
          path.track.resolution = *candidate;
          continue;
        }
      }
      path.refused.set(step);
    }
  return std::nullopt;
}

std::vector<Resolution> Economy::advance(const std::map<Resolution, Measures>& known) {
  std::vector<Resolution> wanted;
  for (auto& path : paths_)
    if (const auto candidate = advance(path, known)) wanted.push_back(*candidate);
  return wanted;
}

std::vector<ProvedTrack> Economy::tracks() const {
  std::vector<ProvedTrack> tracks;
  for (const auto& path : paths_) tracks.push_back(path.track);
  return tracks;
}

}  // namespace fretval
