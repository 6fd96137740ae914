#include "comparison/accuracy/coarsening_search.h"

#include <algorithm>
#include <cmath>

namespace fretval {
namespace {

bool is_fixed(Coarsening step, const FixedByCase& fixed) {
  switch (step) {
    case Coarsening::half_the_rings:
    case Coarsening::three_quarters_of_the_rings:
      return fixed.rings;
    case Coarsening::half_the_steps:
    case Coarsening::three_quarters_of_the_steps:
      return fixed.steps;
    default:
      return false;
  }
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
    : needs_(needs), fixed_(fixed) {
  for (const auto& track : tracks) paths_.push_back({track});
}

std::optional<Resolution> Economy::advance(Path& path, const std::map<Resolution, Measures>& known) const {
  for (; path.n_refused < n_coarsenings; ++path.n_refused, path.next = (path.next + 1) % n_coarsenings) {
    const auto step = static_cast<Coarsening>(path.next);
    while (!is_fixed(step, fixed_)) {
      const auto candidate = coarsened(path.track.resolution, step, needs_);
      if (!candidate) break;
      const auto found = known.find(*candidate);
      if (found == known.end()) return candidate;
      if (!covers(path.track.measures, found->second)) break;
      path.track.resolution = *candidate;
      path.n_refused = 0;
    }
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
