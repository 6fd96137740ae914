#include "fem/wear/wear_archive.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem::wear_archive_test {
namespace {

constexpr WearLaw archard{1e-3};

// Bit for bit, wherever it is left: what a state is written with is all that the next jump depends on. Forces need the
// displacements of the steps before.
TEST(WearArchive, GoesOnAsIfItHadNotBeenLeft) {
  WearingHalfSpace half_space(16);
  half_space.body = {1, {0.3}, {1}, 0.1};
  for (const bool force : {false, true}) {
    half_space.motion.tangential_force = force;
    if (force) half_space.motion.tangential[0].amplitude = 0.5;
    const WearControl control{infinity, 0, 0.02, 1e-6};
    WearState whole{half_space.contact_at_rest(archard)};
    std::vector<std::string> archives;
    wear_on(whole, control, [&](const WearState& state) { archives.push_back(archived(state)); });
    ASSERT_GT(archives.size(), 8u);
    for (const std::size_t left_after : {std::size_t{0}, archives.size() / 2, archives.size() - 1}) {
      WearState rest{half_space.contact_at_rest(archard)};
      restore(archives[left_after], rest);
      wear_on(rest, control);
      EXPECT_EQ(rest.course.worn, whole.course.worn) << left_after;
      EXPECT_EQ(rest.course.curve.back().volume_rate, whole.course.curve.back().volume_rate);
      EXPECT_EQ(rest.course.n_cycles_stepped, whole.course.n_cycles_stepped);
      EXPECT_EQ(rest.course.n_jumps, whole.course.n_jumps);
      EXPECT_EQ(rest.course.largest_jump_error, whole.course.largest_jump_error);
      EXPECT_EQ(rest.course.last.slip, whole.course.last.slip);
      EXPECT_EQ(rest.course.first.pressure, whole.course.first.pressure);
    }
  }
}

TEST(WearArchive, RefusesWhatIsNoArchive) {
  const WearingHalfSpace half_space(16);
  WearState state{half_space.contact_at_rest(archard)};
  wear_on(state, {10, 0, 0.02, 1e-6});
  const auto whole = archived(state);
  for (const auto& bytes : {std::string(), std::string("wear"), whole.substr(0, whole.size() / 2)})
    EXPECT_THROW(restore(bytes, state), std::runtime_error) << bytes.size();
}

}  // namespace
}  // namespace fretval::fem::wear_archive_test
