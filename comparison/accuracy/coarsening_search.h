#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/simulation/resolution.h"

namespace fretval {

/// What is proved of a quantity: its value and the error bar of that.
struct ProvedValue {
  double value, bar, tolerance;
};
using ProvedMeasures = std::map<std::string, ProvedValue>;

/// Whether cheaper measures are proved to be within the tolerance: none lies farther from the proved value than its bar
/// leaves of the tolerance. Measures that are not there are not proved.
bool covers(const ProvedMeasures& proved, const Measures& measures);

/// A resolution, and what it is needed for.
struct ProvedTrack {
  Resolution resolution;
  ProvedMeasures measures;
};

/// Looks for cheaper resolutions than those whose error bars meet the tolerance. Each coarsening is tried in turn on
/// top of those that were accepted, and is accepted if the proof covers what comes out, until none of them is. This
/// finds the end of one path down, not the cheapest of all resolutions, with some twenty computations that are all
/// cheaper than the proof.
class Economy {
 public:
  Economy(const std::vector<ProvedTrack>& tracks, const SceneNeeds& needs, const FixedByCase& fixed);

  /// Goes on as far as the known measures allow (empty measures: the numerics failed). Returns what has to be computed
  /// before it can go on; empty: nothing is left to try.
  std::vector<Resolution> advance(const std::map<Resolution, Measures>& known);

  /// The cheapest so far, with what they are needed for.
  [[nodiscard]] std::vector<ProvedTrack> tracks() const;

 private:
  struct Path {
    ProvedTrack track;
    int next = 0;       // coarsening to be tried
    int n_refused = 0;  // in a row
  };
  std::optional<Resolution> advance(Path& path, const std::map<Resolution, Measures>& known) const;

  SceneNeeds needs_;
  FixedByCase fixed_;
  std::vector<Path> paths_;
};

}  // namespace fretval
