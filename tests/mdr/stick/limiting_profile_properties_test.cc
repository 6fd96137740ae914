#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval::mdr::limiting_profile_properties_test {
namespace {

// Of d_max: a few rounding errors of the two parts that make a worn depth.
constexpr double roundoff = 1e-13;

class Draw {
 public:
  double uniform(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
  double decades(double lowest, double highest) { return std::pow(10, uniform(lowest, highest)); }

 private:
  std::mt19937 random_{5};
};

// Profiles in units of their contact radius.
std::vector<Profile> draw_profiles(Draw& draw) {
  const double flat = draw.uniform(0.01, 0.95), R = draw.decades(-1, 2);
  return {power_law(draw.decades(-3, 1), draw.uniform(0.5, 20)), truncated_sphere(R, flat), rounded_flat(flat, R),
          FlatFaced{flat, draw.decades(-3, 1), 0}};
}

// Convex, with a pointed tip and a kink, far enough beyond the contact at 1.
Profile draw_table(Draw& draw) {
  const double slope = draw.uniform(0, 1), kink = draw.uniform(0.2, 0.8), n = draw.uniform(1, 4);
  std::vector<double> r, f;
  for (int k = 0; k <= 60; ++k) {
    r.push_back(0.03 * k);
    f.push_back(slope * r.back() + std::pow(r.back(), n) + std::max(0.0, r.back() - kink));
  }
  return tabulated(r, f);
}

struct Scene {
  Profile profile;
  double stick_radius, indentation;
};

double shape_scale(const Scene& scene, double r) {
  return roundoff * (scene.indentation + shape(scene.profile, r));
}

Scene scene_of(const Profile& profile, Draw& draw) {
  const double d = transform(profile, 1), a = contact_radius(profile, d), inner = contact_radius(profile, 0);
  const double c = std::min(a, inner + draw.uniform(0.01, 1) * (a - inner));
  return {profile, c, d};
}

// For every profile of many draws.
template <class Check>
void for_scenes(int n_draws, const Check& check) {
  Draw draw;
  for (int i = 0; i < n_draws; ++i) {
    std::vector<Profile> profiles = draw_profiles(draw);
    if (i % 20 == 0) profiles.push_back(draw_table(draw));
    for (const Profile& profile : profiles) check(scene_of(profile, draw), draw);
  }
}

TEST(LimitingProfileProperties, WornZoneReachesBeyondTheContactAndNothingGrows) {
  for_scenes(500, [](const Scene& scene, Draw& draw) {
    const LimitingProfile worn = limiting_profile(scene.profile, scene.stick_radius, scene.indentation);
    ASSERT_GE(worn.outer_radius, contact_radius(scene.profile, scene.indentation));
    for (int k = 0; k < 3; ++k) {
      const double r = draw.uniform(0, 1.1) * worn.outer_radius;
      if (r > end_radius(scene.profile)) continue;
      ASSERT_GE(worn_depth(worn, r), -roundoff * scene.indentation);
      ASSERT_LE(worn_depth(worn, r), scene.indentation);
      // The free surface at d_max lies below the plane of the undeformed body.
      if (r < worn.outer_radius) {
        ASSERT_LE(shape(worn, r), scene.indentation + shape_scale(scene, r));
      }
    }
  });
}

TEST(LimitingProfileProperties, MoreWearsWithLessStickAndMoreIndentation) {
  for_scenes(300, [](const Scene& scene, Draw& draw) {
    const double c = scene.stick_radius, d = scene.indentation;
    const double inner = contact_radius(scene.profile, 0);
    const double less_stick = inner + draw.uniform(0.5, 1) * (c - inner), more_depth = d * draw.uniform(1, 1.1);
    if (end_radius(scene.profile) < 2 && more_depth > 1.02 * d) return;  // the table must reach a_inf
    const LimitingProfile here = limiting_profile(scene.profile, c, d);
    const LimitingProfile less = limiting_profile(scene.profile, less_stick, d);
    const LimitingProfile deeper = limiting_profile(scene.profile, c, more_depth);
    const double slack = 1e-9 * here.outer_radius;  // where f_inf - f0 is flat a_inf is known to no more
    ASSERT_GE(less.outer_radius, here.outer_radius - slack);
    ASSERT_GE(deeper.outer_radius, here.outer_radius - slack);
    for (int k = 0; k < 3; ++k) {
      const double r = draw.uniform(0, 1) * here.outer_radius;
      ASSERT_GE(worn_depth(less, r), worn_depth(here, r) - shape_scale(scene, r));
      ASSERT_GE(worn_depth(deeper, r), worn_depth(here, r) - shape_scale(scene, r));
    }
  });
}

TEST(LimitingProfileProperties, RisesOutwardsWithoutAJump) {
  for_scenes(300, [](const Scene& scene, Draw& draw) {
    const LimitingProfile worn = limiting_profile(scene.profile, scene.stick_radius, scene.indentation);
    const double end = std::min(1.2 * worn.outer_radius, end_radius(scene.profile));
    std::vector<double> radii{draw.uniform(0, end), draw.uniform(0, end), draw.uniform(0, end), worn.stick_radius,
                              worn.outer_radius};
    std::sort(radii.begin(), radii.end());
    for (std::size_t k = 1; k < radii.size(); ++k)
      ASSERT_GE(shape(worn, radii[k]), shape(worn, radii[k - 1]) - shape_scale(scene, radii[k]));
    // arccos(c/r) at c (1 + 1e-14) is sqrt(2e-14); next to a_inf the worn depth vanishes like its distance.
    const double c = worn.stick_radius, jump = scene.indentation - transform(scene.profile, c);
    ASSERT_NEAR(worn_depth(worn, c * (1 + 1e-14)), 0, 1.1e-7 * jump + roundoff * scene.indentation);
    ASSERT_NEAR(worn_depth(worn, worn.outer_radius * (1 - 1e-13)), 0,
                1e-11 * (scene.indentation + shape_slope(scene.profile, worn.outer_radius) * worn.outer_radius));
  });
}

TEST(LimitingProfileProperties, CarriesNoMoreThanTheUnwornOneAtTheSameDepth) {
  for_scenes(500, [](const Scene& scene, Draw& draw) {
    const LimitingProfile worn = limiting_profile(scene.profile, scene.stick_radius, scene.indentation);
    const double d = draw.uniform(0.01, 1) * scene.indentation;
    const double unworn_force = normal_force(scene.profile, 1, d), force = limiting_normal_force(worn, 1, d);
    ASSERT_LE(force, unworn_force * (1 + 1e-12));
    // Nothing that bears is worn as long as the contact stays inside c.
    if (contact_radius(scene.profile, d) < scene.stick_radius) {
      ASSERT_NEAR(force, unworn_force, 1e-12 * unworn_force);
    }
    // The flat punch of radius c bounds it from above.
    ASSERT_LE(force, 8 * scene.stick_radius * d * (1 + 1e-12));
  });
}

}  // namespace
}  // namespace fretval::mdr::limiting_profile_properties_test
