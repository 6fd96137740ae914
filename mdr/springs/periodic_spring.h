#pragma once

#include <Eigen/Core>

#include "mdr/springs/spring_model.h"

namespace fretval::mdr {

/// Periodic state of one spring under an indenter whose face is at the depth y + cos(theta) (unit: Delta d, so
/// y = (d0 - g)/Delta d). The indenter only pushes: contact is lost when the force would become tensile and regained
/// when the indenter meets the recovering tip. All angles in [0, 2 pi]; theta = 0 is the deepest position, always in
/// contact.
struct PeriodicSpring {
  double y;
  double lift_off;                      ///< angle at which the force falls to zero
  double touch_down;                    ///< angle at which contact is regained; equal to lift_off: permanent contact,
                                        /// and both then are the angle of least force
  Eigen::ArrayXd initial_deviation;     ///< v_i minus its value in permanent contact, at theta = 0
  Eigen::ArrayXd touch_down_deviation;  ///< v_i minus its value in permanent contact, at touch_down
};

/// Exact in time but for the two angles, which are located to roundoff: the contact phase is a harmonic plus decaying
/// exponentials, the free phase a sum of modes. The v_i do not change their rate at the events, so at fixed events the
/// cycle is a linear map with the exact derivative, and Newton's method finds the state that repeats itself, however
/// long the relaxation times. For y >= |G|/G0 the contact is permanent.
///
/// Requires y > -1 (below, the indenter never touches): std::invalid_argument. Throws std::runtime_error when the state
/// is not periodic after 50 Newton steps.
PeriodicSpring periodic_spring(const SpringModel& model, double y);

/// Force at theta in [0, 2 pi], divided by 4 G0 Delta d per length; zero while out of contact.
double spring_force(const SpringModel& model, const PeriodicSpring& spring, double theta);

/// Signed angular distance to the nearer event: positive in contact, negative out of contact. It grows with y.
double contact_margin(const PeriodicSpring& spring, double theta);

}  // namespace fretval::mdr
