#pragma once

#include <optional>

#include "comparison/quantities/reading.h"
#include "comparison/simulation/fem_case/fem_case.h"
#include "fem/full_contact/surface_history.h"
#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"

namespace fretval {

/// FeAnswer::cycle of a contact on rings; normal_force_max is dimensionless.
std::optional<CycleReadings> cycle_of(const FemCase& fem, double normal_force_max, const fem::NormalHistory& normal,
                                      const fem::FrictionHistory& friction);

/// Forces and works of a contact on rings and angles, without those of sliding. normal_work: dimensionless work of the
/// normal force.
CycleReadings cycle_of(const FemCase& fem, const fem::SurfaceHistory& history, double normal_work);

/// Adds to the values of a cycle what those of one of its contacts are more than those of another.
void add_change(const CycleReadings& from, const CycleReadings& to, CycleReadings& cycle);

/// Moves the values of a cycle halfway to those of another one.
void go_halfway(const CycleReadings& other, CycleReadings& cycle);

}  // namespace fretval
