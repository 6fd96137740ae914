#pragma once

#include <Eigen/Dense>

#include "fem/compliance.h"
#include "fem/contact_events.h"
#include "fem/normal_history.h"

namespace fretval::fem {

/// A radius and how far the rings may have put it off: not the error of the time steps or of a motion that is not
/// periodic.
struct EdgeRadius {
  double radius;
  double uncertainty;
};

/// Radius of the disc that m active rings stand for, m = 0..n_rings: the flat-punch force of m rings over the force per
/// radius, both from the compliance alone. It is r_m - beta h - gamma h^2/r_m, h the width of the last ring and beta
/// 0.10 to 0.15; the force per radius, beta and, for equal rings, gamma are fitted to the middle half of the discs.
/// Without gamma the radii are off by h^2/8.
/// scatter: largest departure of the fitted discs from that law, in the unit of length: 1e-7 where all rings sit on
/// equal squares, of order h^2/10 on an unstructured mesh. It is what the mesh puts into a radius at random.
struct EffectiveRadii {
  Eigen::VectorXd radius;
  double scatter;
};
EffectiveRadii effective_radii(const Compliance& compliance);

/// Largest contact radius of a cycle from the smallest gap of each ring (see NormalHistory): the remaining gap of the
/// first ring that never touches says how much deeper the indenter would have had to go for the next event. While the
/// contact is the largest so far, the surface moves as in the elastic contact whatever the rheology (Lee & Radok), so
/// the elastic events apply.
EdgeRadius largest_contact_radius(const Eigen::VectorXd& smallest_gap, const ContactEvents& events);

/// Radius at which a slip reserve (see PunchSeries::depths) vanishes, n_stuck: number of rings from the centre that
/// stick. The event of ring j belongs to the mean of the effective radii of j and j+1 rings; the stick radius is where
/// d(r), a parabola fitted to the four outermost events, vanishes: less than a ring beyond the last one. It takes the
/// compliance of the finite elements and nothing else. A radius of 0 if nothing sticks; the middle between the last
/// event and the next one, uncertain by a ring, where the fit goes beyond the next by a quarter of a ring. Uncertainty
/// otherwise: twice the difference from the cubic fitted to the last six events, scatter of the effective radii and
/// h^3/L^2, h the width of the last stuck ring and L the length of the line.
EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& reserve, Eigen::Index n_stuck);

/// Indentation at which a worn flank comes into contact: rings 0..n_pressed-1 are pressed, and the gap of the n_flank
/// rings after them, averaged over their area, closes. profile: ring means.
double touch_indentation(const Compliance& compliance, const Eigen::VectorXd& profile, Eigen::Index n_pressed,
                         Eigen::Index n_flank);

}  // namespace fretval::fem
