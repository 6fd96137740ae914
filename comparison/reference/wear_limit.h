#pragma once

#include <functional>

#include "mdr/layer/layer_limiting_profile.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval {

/// A limiting profile, of a half-space or of a layer. SI units.
struct WearLimit {
  double stick_radius, maximum_indentation, outer_radius;
  double volume;                         ///< worn off up to this profile
  std::function<double(double)> height;  ///< height in m at a radius in m
};
WearLimit wear_limit(const mdr::LimitingProfile& profile);
WearLimit wear_limit(const mdr::LayerLimitingProfile& profile);

}  // namespace fretval
