#include "comparison/accuracy/tracks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

constexpr auto looked_at = Quantity::stick_radius_shakedown;

PreparedCase elastic_parabola() {
  return prepare({suite_case("parabola-elastic-90", 1e-3)}).front();
}

/// The track of a stick radius c over the contact radius after all closer looks that it needs.
struct LookedAt {
  explicit LookedAt(double c) : prepared(elastic_parabola()), tracks{prepared.fem.resolution, {}} {
    Computations computed(prepared.fem.units, fake_compute(prepared, {0, 0, c}), 1);
    const auto look = [&] {
      computed.compute(tracks.all());
      return closer_look(looked_at, tracks, computed, prepared.tolerances);
    };
    for (auto focus = look(); focus && n < 10; focus = look(), ++n) {
      tracks.focused[looked_at] = tracks.base;
      tracks.focused[looked_at].focus = focus;
    }
    radii = computed.at(tracks.of(looked_at)).fe.body->radii;
  }

  PreparedCase prepared;
  Tracks tracks;
  int n = 0;
  std::vector<double> radii;

  [[nodiscard]] long rings_between(double from, double to) const {
    return std::upper_bound(radii.begin(), radii.end(), to) - std::lower_bound(radii.begin(), radii.end(), from) - 1;
  }
};

TEST(Tracks, LeadAllQuantitiesButTheFocusedOnesToTheBase) {
  Tracks tracks{resolution_for(1e-3), {}};
  EXPECT_EQ(tracks.all().size(), 1U);
  auto closer = tracks.base;
  closer.focus = Focus{0, 0.1, 0.01};
  tracks.focused[looked_at] = closer;
  EXPECT_TRUE(tracks.of(looked_at) == closer);
  EXPECT_TRUE(tracks.of(Quantity::stick_radius_first_slip) == tracks.base);
  ASSERT_EQ(tracks.all().size(), 2U);
  EXPECT_TRUE(tracks.all().front() == tracks.base);
}

TEST(CloserLook, EndsWithEnoughRingsInASmallStickZone) {
  for (const double c : {0.002, 0.02, 0.1, 0.15}) {
    const LookedAt looked(c);
    EXPECT_GT(looked.n, 0) << c;
    EXPECT_LT(looked.n, 5) << c;
    EXPECT_GE(looked.rings_between(0, c), 6) << c;
    EXPECT_LT(looked.radii.size(), 150U) << c << ": graded, not fine throughout";
  }
}

TEST(CloserLook, EndsWithEnoughRingsInANarrowSlipAnnulus) {
  for (const double slip : {0.05, 1e-2, 1e-4}) {
    const LookedAt looked(1 - slip);
    EXPECT_GT(looked.n, 0) << slip;
    EXPECT_LT(looked.n, 8) << slip;
    EXPECT_GE(looked.rings_between(1 - slip, 1 + 1e-9), 3) << slip;
  }
}

TEST(CloserLook, IsNoneWhereRingsResolveTheZonesOrNothingSticksByMoreThanTheTolerance) {
  EXPECT_EQ(LookedAt(0.5).n, 0);
  const LookedAt none(0);
  EXPECT_GT(none.n, 0);
  EXPECT_LT(none.n, 10);
  EXPECT_LT(none.radii[1], 1e-3 / 4);
}

TEST(FocusOn, LeavesAloneWhatTheCaseFixesWhatIsWornAndWhatGainsLittle) {
  auto prepared = elastic_parabola();
  const auto focuses = [&](double least_gain) {
    Tracks tracks{prepared.fem.resolution, {}};
    Computations computed(prepared.fem.units, fake_compute(prepared, {0, 0, 0.1}), 1);
    computed.compute(tracks.all());
    const bool did = focus_on(looked_at, least_gain, prepared, computed, tracks);
    EXPECT_EQ(tracks.focused.count(looked_at), did ? 1U : 0U);
    return did;
  };
  EXPECT_TRUE(focuses(2));
  EXPECT_FALSE(focuses(100));
  prepared.input.rings_per_radius = 24;
  EXPECT_FALSE(focuses(2));
  prepared.input.rings_per_radius.reset();
  prepared.fem.kind = ContactKind::worn;
  EXPECT_FALSE(focuses(2));
}

}  // namespace
}  // namespace fretval
