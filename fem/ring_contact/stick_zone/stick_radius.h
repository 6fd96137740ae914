#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"
#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"

namespace fretval::fem {

/// Radius at which a slip reserve (see PunchSeries::depths) vanishes, n_stuck: number of rings from the centre that
/// stick. The event of ring j belongs to EffectiveRadii::of_rings; the stick radius is where
/// d(r), a parabola fitted to the four outermost events, vanishes: less than a ring beyond the last one. It takes the
/// compliance of the finite elements and nothing else. A radius of 0 if nothing sticks; the middle between the last
/// event and the next one, uncertain by a ring, where the fit goes beyond the next by a quarter of a ring. Uncertainty
/// otherwise: twice the difference from the cubic fitted to the last six events (from the line through two, if there
/// are three), scatter of the effective radii and h^3/L^2, h the width of the last stuck ring and L the length of the
/// line.
EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& reserve, Eigen::Index n_stuck);

/// With the effective radii of the compliance, which several readings of one body share: to find them takes a
/// factorisation of it, and on another body than a half-space of its pairs of rings, too.
EdgeRadius stick_radius(const Compliance& compliance, const EffectiveRadii& edges, const Eigen::VectorXd& reserve,
                        Eigen::Index n_stuck);

}  // namespace fretval::fem
