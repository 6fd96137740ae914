#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>

#include "comparison/simulation/bodies/normal_store.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// How finely the histories of a case are computed, and for how long.
fem::HistoryControl control_of(const FemCase& fem);

/// What a case is computed from: its normal history, and the largest contact radius.
struct NormalPart {
  std::shared_ptr<const NormalRecord> record;
  Eigen::VectorXd profile;  ///< ring means
  std::optional<ContactRadius> contact_radius;
};

/// From the store, which computes it where nobody has.
NormalPart normal_part(const ContactProblems& problems, const FemCase& fem, NormalStore& normals);

}  // namespace fretval
