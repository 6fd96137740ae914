#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <vector>

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/fem_case/fem_case.h"
#include "fem/wear/end_of_wear.h"
#include "fem/wear/wear_course.h"

namespace fretval {

/// Wear of an indenter by finite elements; dimensionless, in the units of its case.
struct WearSimulation {
  fem::WearCourse course;
  fem::EndOfWear end;         ///< of the course, to a share of a ring
  double end_volume = 0;      ///< worn off then
  std::vector<double> radii;  ///< of the rings
  std::shared_ptr<const BodySummary> body;
  Eigen::VectorXd unworn;              ///< height at the centres of the rings
  Eigen::VectorXd centre;              ///< of each ring: the radius of half of its area
  double worn_radius = 0;              ///< where the worn profile meets the unworn one
  double worn_radius_uncertainty = 0;  ///< of reading it
  double seconds = 0;
};

/// The resolution that shows a worn profile to less than a thousandth of the largest indentation.
///
/// At the stick radius pressure and traction become singular, and whether a ring there still sticks is decided by the
/// ratio of the two in the last ring. On a half-space it is that of two flat punches, 2/3, for discs of any radius; for
/// finite elements it is off by a share that no refinement of the rings reduces, only the degree: 8e-2, 1.5e-3, 3e-3
/// and 1e-4 for degrees 2 to 5. By a third of that share, over the contact radius, wear would eat into the stick zone.
/// Therefore wear takes degree 5, and its error is measured by degree 3.
Resolution resolution_for_wear(const Resolution& of_the_case);

/// What is done beside on the way through a course of wear.
struct WearRun {
  std::filesystem::path checkpoints = {};  ///< folder of WearCheckpoint; empty: none
  /// Called after each jump with the rings, and the course so far.
  std::function<void(const WearSimulation& rings, const fem::WearCourse& course)> progress = {};
};

/// settled_edge() of wear on coarse rings.
WornEdge edge_of_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius, BodyStore& bodies,
                      const WearRun& run = {});

/// Runs the wear of a case to its end. edge: rings are graded around its inner radius (0: equal rings), and the contact
/// line reaches beyond the outer one.
WearSimulation simulate_wear(const FemCase& fem, const Case::WearKinetics& wear, const WornEdge& edge,
                             const Resolution& resolution, BodyStore& bodies, const WearRun& run = {});

}  // namespace fretval
