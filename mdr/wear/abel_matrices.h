#pragma once

#include <Eigen/Core>

#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// The transforms between the springs of a bed and the rings of surface over their intervals as square matrices, for
/// use again and again on the same bed. Fields are constant per ring and per interval, transforms are exact means of
/// what such fields give:
///
///   image(j,i)         mean over interval j of g = |x| int_0^|x| f'(r)/sqrt(x^2-r^2) dr of ring i raised by 1     (3)
///   stress(i,j)        mean over ring i of -(1/pi) int_r q'(x)/sqrt(x^2-r^2) dx of interval j loaded by 1
///   displacement       inverse of image: means (2/pi) int_0^r u(x)/sqrt(r^2-x^2) dx of the surface over the rings  (4)
///
/// Source: paper, equations (3) and (4); Popov and Hess 2015, chapter 3. What holds exactly, and keeps long chains of
/// transforms stable:
///   - triangular: heights and displacements act outwards, loads inwards;
///   - a uniform height or displacement is reproduced, and no displacement mean leaves the range of the springs', as
///     image has a positive diagonal, negative entries below it and row sums of 1: its inverse is not negative;
///   - area_i stress(i,j) = 2 width_j image(j,i): works of surface and springs are equal, total loads too.
/// Errors fall with the power 3/2 of the width for smooth fields, with 1/2 where a field is a root at its edge.
struct AbelMatrices {
  Eigen::MatrixXd image;
  Eigen::MatrixXd stress;  ///< Pa per N/m
  Eigen::MatrixXd displacement;
  Eigen::ArrayXd area;  ///< of the rings, m^2
};

/// Any widths; throws std::invalid_argument unless the intervals follow each other from the axis.
AbelMatrices abel_matrices(const SpringBed& bed);

}  // namespace fretval::mdr
