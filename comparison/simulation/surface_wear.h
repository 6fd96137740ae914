#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/surface_answer.h"
#include "fem/wear/wear_course.h"

namespace fretval {

/// Wear of an indenter under friction as a vector by finite elements; dimensionless, in the units of its case. The
/// shape need not stay axisymmetric. Points are those of rings x kept angles, angle by angle.
struct SurfaceWear {
  fem::WearCourse course;
  fem::AngularGrid grid;
  std::vector<double> radii;  ///< of the rings
  fem::ContactRegion sticks;  ///< where nothing slips at the end; the uncertainty of its edge is a ring
  Eigen::VectorXd unworn;     ///< ring means of the height
  double seconds = 0;

  /// A field of the points, rings x kept angles.
  [[nodiscard]] Eigen::MatrixXd field(const Eigen::VectorXd& points) const;
};

/// The resolution that a worn surface is computed at, with the rings and steps that the case file sets, if it does.
/// Where traction and pressure of a zone that sticks are singular, their ratio decides what sticks, so that degree 5 is
/// taken, as for the wear of rings (resolution_for_wear).
Resolution resolution_for_surface_wear(const Case& input, const Resolution& of_the_case);

/// settled_edge() of wear on half of the rings and steps of a resolution.
WornEdge edge_of_surface_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius,
                              const Resolution& resolution, BodyStore& bodies,
                              const std::filesystem::path& checkpoints);

/// Runs the wear of a case with friction as a vector to its end. edge: rings are graded around its inner radius (0:
/// equal rings), and the contact line reaches beyond the outer one. Throws fem::SolverError where the numerics fail.
SurfaceWear simulate_surface_wear(const FemCase& fem, const Case::WearKinetics& wear, const WornEdge& edge,
                                  const Resolution& resolution, BodyStore& bodies,
                                  const std::filesystem::path& checkpoints,
                                  const std::function<void(const fem::WearCourse&)>& after_jump);

}  // namespace fretval
