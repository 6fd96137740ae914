#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"
#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"

namespace fretval::fem {

/// Radius at which a slip reserve (see PunchSeries::depths) vanishes, n_stuck: number of rings from the centre that
/// stick. The event of ring j belongs to EffectiveRadii::of_rings; the stick radius is where d(r), a parabola fitted to
/// the four outermost events, vanishes: less than a ring beyond the last one. Only the compliance of the finite
/// elements is used. The radius is 0 if nothing sticks. Where the fit lies more than a quarter of a ring beyond the
/// next event, the radius is the middle between the last event and the next one, uncertain by a ring. The uncertainty
/// otherwise: twice the difference from the cubic fitted to the last six events (from the line through two, if there
/// are three or the cubic vanishes too far out), scatter of the effective radii and h^3/L^2, h the width of the last
/// stuck ring and L the length of the line.
EdgeRadius stick_radius(const Compliance& compliance, const Eigen::VectorXd& reserve, Eigen::Index n_stuck);

/// The stick radius with effective radii that are known, which several readings of one body share: to find them takes a
/// factorisation of the compliance and, on another body than a half-space, one of its pairs of rings.
EdgeRadius stick_radius(const Compliance& compliance, const EffectiveRadii& edges, const Eigen::VectorXd& reserve,
                        Eigen::Index n_stuck);

}  // namespace fretval::fem
