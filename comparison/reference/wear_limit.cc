#include "comparison/reference/wear_limit.h"

namespace fretval {
namespace {

template <class Profile>
WearLimit limit_of(const Profile& profile) {
  return {profile.stick_radius, profile.maximum_indentation, profile.outer_radius, mdr::worn_volume(profile),
          [profile](double r) { return mdr::shape(profile, r); }};
}

}  // namespace

WearLimit wear_limit(const mdr::LimitingProfile& profile) {
  return limit_of(profile);
}

WearLimit wear_limit(const mdr::LayerLimitingProfile& profile) {
  return limit_of(profile);
}

}  // namespace fretval
