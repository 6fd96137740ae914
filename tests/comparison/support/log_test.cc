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

TEST(Log, WarnsOnceOfWhatManyCasesHave) {
  testing::internal::CaptureStderr();
  if (!log::tells()) log::start();
  for (const char* message : {"a table is sparse", "another is", "a table is sparse"}) log::warn_once(message);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: a table is sparse\nwarning: another is\n");
}

}  // namespace
}  // namespace fretval
