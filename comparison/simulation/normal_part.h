#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>

#include "comparison/simulation/bodies/normal_store.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// How finely the histories of a case are computed, and for how long.
fem::HistoryControl control_of(const FemCase& fem);

/// The normal part of a case: its normal history, and the largest contact radius.
struct NormalPart {
  std::shared_ptr<const NormalRecord> record;
  Eigen::VectorXd profile;  ///< ring means
  std::optional<ContactRadius> contact_radius;
};

/// The normal part of a case from the store, which computes it if it is not there.
NormalPart normal_part(const ContactProblems& problems, const FemCase& fem, NormalStore& normals);

}  // namespace fretval
