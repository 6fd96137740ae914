#pragma once

#include <vector>

#include "comparison/verification/written_case.h"

namespace fretval {

/// Sections of case files, as several suites need them; SI units, angles in degrees.
Entries parabola(double radius);
Entries sphere(double radius);
Entries cone(double degrees);
Entries power(double exponent, double coefficient);
Entries rounded_flat(double flat_radius, double edge_radius);
Entries truncated_sphere(double radius, double flat_radius);

Entries elastic(double modulus);
Entries kelvin_voigt(double modulus, double viscosity);
Entries branches(const std::string& rheology, double modulus, const std::vector<double>& moduli,
                 const std::vector<double>& times);

/// The entries with another indenter or another elastomer, whose section takes the place of the old one.
Entries with_section(const Entries& entries, const Entries& section);

}  // namespace fretval
