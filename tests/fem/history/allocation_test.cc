// A step works in the memory that is there. A sanitizer has its own malloc, and nothing to count with: GCC names it by
// a macro, clang by a feature.
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAS_MALLOC_OF_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_MALLOC_OF_SANITIZER
#endif
#ifndef HAS_MALLOC_OF_SANITIZER

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>

#include "fem/history/friction_history.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace {

thread_local long count = 0;

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t size);

/// In the place of the library's own, for Eigen and everybody else.
void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
}

namespace fretval::fem::allocation_test {
namespace {

constexpr int steps_per_cycle = 36;

long allocations_in(const std::function<void()>& work) {
  const long before = count;
  work();
  return count - before;
}

class AllocationTest : public testing::Test {
 protected:
  const Motion motion_ = [] {
    auto motion = one_frequency(0.8, 0.2, 0.3, 0.7);
    motion.n_ramp_cycles = 1;
    return motion;
  }();
  const Eigen::VectorXd profile_ = parabola_means(normal_half_space(32));
};

// Through a cycle in which rings lift and touch, and the contact goes back and grows again.
TEST_F(AllocationTest, NormalStepsNeedNoMemory) {
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    NormalContact contact(normal_half_space(32), body, profile_, motion_, steps_per_cycle);
    EXPECT_GT(allocations_in([&] { contact.step(); }), 0) << "it begins with none";
    while (contact.n_steps < 2L * steps_per_cycle) contact.step();
    for (int k = 0; k < steps_per_cycle; ++k) EXPECT_EQ(allocations_in([&] { contact.step(); }), 0) << k;
  }
}

// Nor here, but for a step or none of a cycle: of rings that do not stick around the centre, as the solver may try it
// on its way, it makes a matrix.
TEST_F(AllocationTest, FrictionStepsNeedNone) {
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    NormalContact normal(normal_half_space(32), body, profile_, motion_, steps_per_cycle);
    WatchedFriction friction(tangential_half_space(32), body, 0.5, motion_, steps_per_cycle);
    const auto step = [&] {
      normal.step();
      return allocations_in([&] { friction.step_beside(normal); });
    };
    EXPECT_GT(step(), 0) << "it begins with none";
    while (friction.contact.n_steps < 2L * steps_per_cycle) step();
    step();  // keeps what the last period was like
    int n_that_need_some = 0;
    for (int k = 2; k < steps_per_cycle; ++k) n_that_need_some += step() > 0;
    EXPECT_LE(n_that_need_some, 1);
  }
}

}  // namespace
}  // namespace fretval::fem::allocation_test

#endif
