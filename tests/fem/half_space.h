#pragma once

#include "fem/operators/grid_data.h"
#include "fem/operators/harmonic_space.h"
#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// A quarter disc as the grid of a body. contact_length is split into n_contact rings.
GridData quarter_disc_grid(double contact_length, unsigned n_contact, double far_radius, double growth);

/// A layer on a base to which it is bonded or on which it slides, so wide that its side does not matter, with such a
/// contact line.
GridData layer_grid(double contact_length, unsigned n_contact, double thickness, double growth,
                    BoundaryPart base = BoundaryPart::bonded);

/// The half-space of the tests, of unit shear modulus, condensed to a contact line of length 1.125 with n_per_radius
/// rings per unit length (a multiple of 8, so that r = 1 is a node). Cut off at 25, growth 0.15. Built once a process.
const ContactProblem& half_space(const FourierOrder& order, unsigned n_per_radius, unsigned degree = 3);

inline const ContactProblem& normal_half_space(unsigned n_per_radius) {
  return half_space(axisymmetric, n_per_radius);
}

inline const ContactProblem& tangential_half_space(unsigned n_per_radius) {
  return half_space(lateral, n_per_radius);
}

/// The same with a line of 1.375, for indenters that wear beyond their first contact.
const ContactProblem& long_half_space(const FourierOrder& order, unsigned n_per_radius);

}  // namespace fretval::fem
