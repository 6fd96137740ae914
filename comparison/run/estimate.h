#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/proof.h"

namespace fretval {

/// About how long finite elements need, in s on one core of today; right to a factor of three, of wear to a
/// factor of five.

/// n_sharing: number of cases that share a body.

/// Seconds of one computation.
double seconds_of_one(const Resolution& resolution, int highest_order, std::size_t n_sharing = 1);

/// Seconds of n_computations of an unworn case, one at this resolution and the others at variants of it.
double estimated_seconds(const Resolution& resolution, int highest_order, std::size_t n_computations,
                         std::size_t n_sharing = 1);

/// Seconds of a case with its proof, and with its wear.
double estimated_seconds(const PreparedCase& prepared, Proof proof, std::size_t n_sharing = 1);

/// Seconds of each of the cases, by its name, where so many cores share them, and they share their bodies.
std::map<std::string, double> estimated_seconds(const std::vector<PreparedCase>& cases, Proof proof,
                                                std::size_t n_cores);

/// Indices of the cases, those first that are estimated to take long: one of them at the end would go on alone. Cases of
/// equal estimates stay neighbours.
std::vector<std::size_t> longest_first(const std::vector<PreparedCase>& cases, Proof proof);

/// Whether the steady motion slides by the balance of forces (steady_sliding_share), which a computation finds at once.
bool slides(const PreparedCase& prepared);

/// How many computations the error bars of an unworn case take, the case itself among them.
std::size_t computations_for_bars(const FemCase& fem);

}  // namespace fretval
