#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "comparison/simulation/body_store.h"
#include "comparison/simulation/fem_case.h"
#include "fem/wear/wear_course.h"

namespace fretval {

/// What finite elements say about an indenter that wears: dimensionless, in the units of its case.
struct WearSimulation {
  fem::WearCourse course;
  std::vector<double> radii;  ///< of the rings
  Eigen::VectorXd unworn;     ///< ring means of the height
  Eigen::VectorXd centre;     ///< of each ring: the radius of half of its area
  double worn_radius = 0;     ///< where the worn profile meets the unworn one
  double seconds = 0;
};

/// The resolution that shows a worn profile to a thousandth of the largest indentation: rings that are fine at the
/// stick radius, where the profile is vertical in the end, and fine enough at the outer edge of the wear.
Resolution resolution_for_wear(const Resolution& of_the_case);

/// Runs the wear of a case to its end. stick_radius: around which rings are graded, over the unit of length; 0: equal
/// rings. The contact line reaches as far as any wear can.
WearSimulation simulate_wear(const FemCase& fem, const Case::WearKinetics& wear, double stick_radius,
                             const Resolution& resolution, BodyStore& bodies, const fem::WearProgress& progress = {});

}  // namespace fretval
