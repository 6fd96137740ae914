#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Entries of a case file by "SECTION / ENTRY". An empty value: the entry is not set.
using Entries = std::map<std::string, std::string>;

/// A number as a case file takes it, exact to the last bit.
std::string entry_text(double value);

/// The entries with some of them changed or added.
Entries with(Entries entries, const Entries& changes);
Entries with_numbers(Entries entries, const std::map<std::string, double>& changes);

/// A case with the tangential amplitude that shakes down at a stick radius of c, stick_ratio = c over the unworn
/// contact radius at the largest indentation, times a factor; stick_ratio = 0: at the border to where nothing sticks.
/// Throws InputError if there is none.
Entries with_stick_ratio(const Entries& entries, double stick_ratio, double factor = 1);

/// The entries as the text of a case file (.prm).
std::string case_text(const Entries& entries);

/// Reads the entries as `fretval run` reads a case file. file: for messages. Throws InputError.
Case case_of(const Entries& entries, const std::string& name, const std::string& file = "suite extremes");

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
