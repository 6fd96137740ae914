#pragma once

#include <vector>

namespace fretval::mdr {

/// Largest (sign 1) or smallest (sign -1) value of a periodic signal in equal steps, both ends included, three samples
/// at least: at the vertex of the parabola through the extreme sample and its neighbours.
double sampled_peak(const std::vector<double>& samples, double sign);

/// Largest magnitude of a tangential force, in N, by sampled_peak; it is not more than mu times the largest normal
/// force next to its sample, which may lie between two samples as well. Where a sliding contact turns, a parabola goes
/// beyond that.
double friction_peak(const std::vector<double>& tangential, const std::vector<double>& normal, double mu);

}  // namespace fretval::mdr
