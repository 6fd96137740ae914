#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "fem/history/contact_problem.h"

namespace fretval::fem {

/// Mean over each ring of a profile f(r).
Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f);

/// Ring pressures of a contact and the remaining gaps.
struct StaticContact {
  Eigen::VectorXd pressure, gap;
};

/// Elastic normal contact with unit shear modulus. target: displacements of the rings that would close their gaps;
/// states: warm start on entry, those of the solution on exit (interior: touches).
StaticContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& states);

/// The same at a fixed indentation; profile: ring means.
StaticContact static_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation);

}  // namespace fretval::fem
