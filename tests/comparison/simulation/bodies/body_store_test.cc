#include "comparison/simulation/bodies/body_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "comparison/support/parallel.h"
#include "fem/support/solver_error.h"
#include "tests/comparison/small_body.h"

namespace fretval {
namespace {

TEST(BodyStore, MakesABodyOnceForManyThreads) {
  BodyStore store;
  std::atomic<int> n_made{0};
  std::vector<std::shared_ptr<const ContactBody>> bodies(8);
  for_each_in_parallel(
      bodies.size(),
      [&](std::size_t i) {
        bodies[i] = store.find_or_make(small_body(i % 2 == 0), [&] {
          ++n_made;
          std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that the others ask meanwhile
          return contact_body(make_body(small_body(i % 2 == 0)));
        });
      },
      bodies.size());
  EXPECT_EQ(n_made, 2);
  EXPECT_EQ((std::set<std::shared_ptr<const ContactBody>>(bodies.begin(), bodies.end()).size()), 2U);
  EXPECT_TRUE(bodies[0]->tangential);
  EXPECT_FALSE(bodies[1]->tangential);
}

TEST(BodyStore, ThrowsToWhoeverAsksForWhatCouldNotBeMade) {
  BodyStore store;
  int n_tried = 0;
  const auto ask = [&] {
    store.find_or_make(small_body(), [&]() -> ContactBody {
      ++n_tried;
      throw fem::SolverError("singular");
    });
  };
  EXPECT_THROW(ask(), fem::SolverError);
  EXPECT_THROW(ask(), fem::SolverError);
  EXPECT_EQ(n_tried, 1);
}

}  // namespace
}  // namespace fretval
