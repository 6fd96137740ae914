#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/support/made_once.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval {

/// MDR's normal responses (see mdr_normal_response): cases that differ only in phase, friction or tangential amplitude
/// share one.
class NormalResponses {
 public:
  /// mdr: of the same case. Throws what mdr_normal_response throws.
  std::shared_ptr<const mdr::NormalResponse> of(const Case& input, const MdrCase& mdr);

 private:
  using Indenter = std::tuple<Case::Shape, double, double, double, double, double, double, std::string, double>;
  using Layer = std::tuple<double, double, bool>;  // thickness, Poisson's ratio, bonded
  using Body = std::tuple<double, std::vector<double>, std::vector<double>, double, std::optional<Layer>>;
  using Motion = std::tuple<bool, double, std::vector<std::tuple<double, double, double>>>;
  /// The last part of the key is the stick radius of the limiting profile, or 0.
  MadeOnce<std::tuple<Indenter, Body, Motion, double>, mdr::NormalResponse> responses_;
};

}  // namespace fretval
