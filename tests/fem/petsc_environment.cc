#include <gtest/gtest.h>

#include <memory>

#include "fem/condensation/petsc_session.h"

namespace fretval::fem {
namespace {

class PetscEnvironment : public testing::Environment {
 public:
  void SetUp() override { session_ = std::make_unique<PetscSession>(); }
  void TearDown() override { session_.reset(); }

 private:
  std::unique_ptr<PetscSession> session_;
};

const testing::Environment* const environment = testing::AddGlobalTestEnvironment(new PetscEnvironment);

}  // namespace
}  // namespace fretval::fem
