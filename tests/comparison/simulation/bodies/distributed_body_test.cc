#include "comparison/simulation/bodies/distributed_body.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/simulation/bodies/body_store.h"
#include "fem/support/solver_error.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/small_body.h"

// By one process; by several: tests/comparison/run/ranked_batch_test.cc.
namespace fretval::distributed_body_test {
namespace {

class DistributedBody : public testing::Test {
 protected:
  Distribution counted_{1, 1, [this](const std::string& specification) {
                          ++n_asked_;
                          return operators_made_together(specification, {});
                        }};
  int n_asked_ = 0;
};

void expect_near(const fem::ContactProblem& a, const fem::ContactProblem& b) {
  EXPECT_EQ(a.compliance.radii, b.compliance.radii);
  EXPECT_EQ(a.compliance.areas, b.compliance.areas);
  EXPECT_LT((*a.compliance.matrix - *b.compliance.matrix).norm(), 1e-11 * b.compliance.matrix->norm());
}

TEST_F(DistributedBody, IsTheOneThatOneProcessMakes) {
  for (const bool tangential : {false, true}) {
    const auto expected = contact_body(make_body(small_body(tangential)));
    const auto body = distributed_body(small_body(tangential), {}, counted_, nullptr);
    expect_near(body.normal, expected.normal);
    ASSERT_EQ(body.tangential.has_value(), tangential);
    if (tangential) expect_near(*body.tangential, *expected.tangential);
    EXPECT_EQ(body.summary->n_dofs, expected.summary->n_dofs);
    EXPECT_EQ(body.summary->n_contact_nodes, expected.summary->n_contact_nodes);
    EXPECT_EQ(body.summary->mesh_quality.n_cells, expected.summary->mesh_quality.n_cells);
    EXPECT_FALSE(body.summary->from_store);
    EXPECT_GT(body.summary->cost.factorisation, 0);
  }
}

TEST_F(DistributedBody, IsKeptForTheNextRunOfAsManyProcesses) {
  const ScratchFolder scratch;
  OperatorStore store(scratch.path());
  distributed_body(small_body(), {}, counted_, &store);
  EXPECT_TRUE(distributed_body(small_body(), {}, counted_, &store).summary->from_store);
  EXPECT_EQ(n_asked_, 1);
  const Distribution two{1, 2, counted_.make_together};
  EXPECT_FALSE(distributed_body(small_body(), {}, two, &store).summary->from_store);
}

TEST_F(DistributedBody, IsMadeOfLargeBodiesAlone) {
  BodyStore bodies;
  bodies.distribution = counted_;
  const auto n_dofs = n_dofs_on(mesh_of(small_body()), small_body().degree, true);
  bodies.distribution->from_dofs = n_dofs + 1;
  find_or_make_body(small_body(true), bodies);
  EXPECT_EQ(n_asked_, 0);
  bodies.distribution->from_dofs = n_dofs;
  find_or_make_body(small_body(false), bodies);
  EXPECT_EQ(n_asked_, 0);
  BodyStore others;
  others.distribution = bodies.distribution;
  find_or_make_body(small_body(true), others);
  EXPECT_EQ(n_asked_, 1);
  EXPECT_EQ(others.n_made, 1);
}

TEST_F(DistributedBody, SaysWhyTheNumericsFailed) {
  Distribution broken = counted_;
  broken.make_together = [](const std::string&) {
    std::string answer;
    nlohmann::json::to_cbor({{"failure", "the pump is broken"}, {"operators", nlohmann::json::array()}}, answer);
    return answer;
  };
  try {
    distributed_body(small_body(), {}, broken, nullptr);
    FAIL() << "no error";
  } catch (const fem::SolverError& error) {
    EXPECT_STREQ(error.what(), "the pump is broken");
  }
}

}  // namespace
}  // namespace fretval::distributed_body_test
