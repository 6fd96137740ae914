#include "comparison/simulation/bodies/kept_body.h"

#include <gtest/gtest.h>

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/bodies/operator_key.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/small_body.h"

namespace fretval::kept_body_test {
namespace {

namespace fs = std::filesystem;

class KeptBody : public testing::Test {
 protected:
  std::shared_ptr<const ContactBody> body_of_a_new_run(const BodyDescription& specification) const {
    BodyStore run(std::make_shared<OperatorStore>(scratch_.path()));
    return find_or_make_body(specification, run);
  }

  ScratchFolder scratch_;
  OperatorStore store_{scratch_.path()};
};

void expect_equal(const fem::ContactProblem& a, const fem::ContactProblem& b) {
  EXPECT_EQ(a.compliance.radii, b.compliance.radii);
  EXPECT_EQ(a.compliance.areas, b.compliance.areas);
  EXPECT_EQ(*a.compliance.matrix, *b.compliance.matrix);
  EXPECT_EQ(*a.solver.factor(), *b.solver.factor());
}

TEST_F(KeptBody, IsTheOneThatWasMadeBitForBit) {
  const auto made = body_of_a_new_run(small_body()), kept = body_of_a_new_run(small_body());
  EXPECT_FALSE(made->summary->from_store);
  ASSERT_TRUE(kept->summary->from_store);
  expect_equal(made->normal, kept->normal);
  expect_equal(*made->tangential, *kept->tangential);
  const auto &a = *made->summary, &b = *kept->summary;
  EXPECT_EQ(a.radii, b.radii);
  EXPECT_EQ(a.n_dofs, b.n_dofs);
  EXPECT_EQ(a.n_contact_nodes, b.n_contact_nodes);
  const auto &p = a.mesh_quality, &q = b.mesh_quality;
  EXPECT_EQ(std::tie(p.n_cells, p.n_nodes, p.min_scaled_jacobian, p.mean_scaled_jacobian, p.max_aspect_ratio, p.area,
                     p.smallest_edge, p.largest_edge),
            std::tie(q.n_cells, q.n_nodes, q.min_scaled_jacobian, q.mean_scaled_jacobian, q.max_aspect_ratio, q.area,
                     q.smallest_edge, q.largest_edge));
}

TEST_F(KeptBody, CostsTheReadingAlone) {
  const auto made = body_of_a_new_run(small_body())->summary, kept = body_of_a_new_run(small_body())->summary;
  EXPECT_GT(made->cost.factorisation, 0);
  EXPECT_EQ(made->cost.reading, 0);
  EXPECT_EQ(kept->cost.factorisation, 0);
  EXPECT_EQ(kept->cost.total(), kept->cost.reading);
  EXPECT_GT(kept->cost.reading, 0);
}

TEST_F(KeptBody, NeedsAllHarmonicsOfItsBody) {
  body_of_a_new_run(small_body(false));
  EXPECT_TRUE(kept_body(small_body(false), {}, store_));
  EXPECT_FALSE(kept_body(small_body(true), {}, store_));
  EXPECT_FALSE(body_of_a_new_run(small_body(true))->summary->from_store);
  EXPECT_TRUE(kept_body(small_body(true), {}, store_));
  fs::remove(store_.file_of(operator_key(small_body(), fem::axisymmetric)));
  EXPECT_FALSE(kept_body(small_body(true), {}, store_));
}

TEST_F(KeptBody, IsCountedByTheRun) {
  BodyStore first(std::make_shared<OperatorStore>(scratch_.path()));
  find_or_make_body(small_body(), first);
  find_or_make_body(small_body(), first);
  EXPECT_EQ(first.n_made, 1);
  EXPECT_EQ(first.n_kept, 0);
  BodyStore second(std::make_shared<OperatorStore>(scratch_.path()));
  find_or_make_body(small_body(), second);
  EXPECT_EQ(second.n_made, 0);
  EXPECT_EQ(second.n_kept, 1);
}

// The key does not know a mesh that somebody has drawn.
TEST_F(KeptBody, IsNeverOneOnAMeshOfSomebodyElse) {
  body_of_a_new_run(small_body());
  BodyStore own_mesh{MeshSource{}};
  EXPECT_FALSE(find_or_make_body(small_body(), own_mesh)->summary->from_store);
  BodyStore without;
  EXPECT_FALSE(find_or_make_body(small_body(), without)->summary->from_store);
}

TEST_F(KeptBody, CountsDifferentBodiesOnce) {
  const auto made = body_of_a_new_run(small_body())->summary, kept = body_of_a_new_run(small_body())->summary;
  const auto count = count_of({made, kept, nullptr, made});
  EXPECT_EQ(count.all, 2);
  EXPECT_EQ(count.from_store, 1);
}

}  // namespace
}  // namespace fretval::kept_body_test
