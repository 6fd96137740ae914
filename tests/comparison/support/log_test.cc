#include "comparison/support/log.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

// A message may hold what a format or a file has in it.
TEST(Log, WritesMessagesAsTheyAreToTheStandardError) {
  testing::internal::CaptureStderr();
  if (!log::tells()) log::start();
  log::info("{} of {}");
  log::warn("careful");
  log::error("it failed: 5 %");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "info: {} of {}\nwarning: careful\nerror: it failed: 5 %\n");
}

}  // namespace
}  // namespace fretval
