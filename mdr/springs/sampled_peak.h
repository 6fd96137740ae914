#pragma once

#include <vector>

namespace fretval::mdr {

/// Largest (sign 1) or smallest (sign -1) value of a periodic signal in equal steps, both ends included, three samples
/// at least: at the vertex of the parabola through the extreme sample and its neighbours.
double sampled_peak(const std::vector<double>& samples, double sign);

}  // namespace fretval::mdr
