#pragma once

#include "mdr/wear/abel_matrices.h"
#include "mdr/wear/wear_cycle.h"

namespace fretval::mdr {

/// A settled cycle of a sphere of radius 1 m on springs to 1.6 m, for mu = 0.6.
struct MeasuredCycle {
  AbelMatrices matrices;
  WearCycle cycle;
  SpringBed bed;
};

inline MeasuredCycle measured_cycle(const PronyBody& body, const Motion& motion, Eigen::Index n, int steps) {
  const SpringBed bed = spring_bed(parabola(1), 1.6, n);
  const AbelMatrices matrices = abel_matrices(bed);
  return {matrices, WearingSprings(bed, body, 0.6, motion, steps).settled_cycle(matrices), bed};
}

/// int p |ds| of the rings in a cycle over the relaxed modulus, m^2.
inline Eigen::ArrayXd pressure_path(const MeasuredCycle& m) {
  const Eigen::MatrixXd load = m.cycle.load.cwiseMax(0);
  return 4 * m.matrices.stress.cwiseProduct(m.cycle.path * load.transpose()).rowwise().sum().array();
}

}  // namespace fretval::mdr
