#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/distance_to_limit.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/reference/mdr_wear.h"
#include "comparison/simulation/wear_simulation.h"

namespace fretval {

using WearComputation = Computed<WearSimulation>;

/// What is kept of a course of wear on its way, and who is told of its progress.
struct WearOversight {
  std::filesystem::path checkpoints = {};  ///< folder of WearCheckpoint; empty: none
  /// Called after each jump, one call at a time: the share of all work that is done, and the distance of the profile
  /// that has just worn from the limit of shakedown, see distances_of.
  std::function<void(double share, double distance)> progress = {};
};

/// A worn profile as a chain of points at the centres of its rings. unit: unit of its heights over the largest
/// indentation.
ProfileChain chain_of(const WearSimulation& wear, const Eigen::VectorXd& worn, double unit);

/// Distance of the profile at each point of a course from a limit (distance_between), in the plane of r over the unworn
/// contact radius and f over the largest indentation.
std::vector<double> distances_of(const WearSimulation& wear, const Units& units, const WearLimit& limit);

/// The wear of a case at all the resolutions that are asked for, each computed once.
class WearComputations {
 public:
  WearComputations(const PreparedCase& prepared, const WornEdge& edge, const WearLimits& limits, BodyStore& bodies,
                   WearOversight oversight)
      : prepared_(prepared), edge_(edge), limits_(limits), bodies_(bodies), oversight_(std::move(oversight)) {}

  /// Computes the resolutions that are not there yet.
  void compute(const std::vector<Resolution>& wanted);

  [[nodiscard]] ProofCost cost() const;

  std::map<Resolution, WearComputation> all;

 private:
  [[nodiscard]] WearComputation attempt(const Resolution& resolution);
  void tell(const Resolution& resolution, double share, double distance);

  const PreparedCase& prepared_;
  WornEdge edge_;
  const WearLimits& limits_;
  BodyStore& bodies_;
  WearOversight oversight_;
  std::mutex mutex_;
  std::map<Resolution, double> shares_;  // share of each computation that is done
};

}  // namespace fretval
