#include "comparison/support/cache_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/comparison/variable.h"

namespace fretval::cache_folder_test {
namespace {

TEST(CacheFolder, IsThatOfXdgOrInTheHomeOfTheUser) {
  const Variable cache("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/somebody");
  EXPECT_EQ(cache_folder(), "/somewhere/cache/fretval");
  for (const char* not_set : {"", "not/absolute"}) {
    const Variable other("XDG_CACHE_HOME", not_set);
    EXPECT_EQ(cache_folder(), "/home/somebody/.cache/fretval");
    const Variable homeless("HOME", not_set);
    EXPECT_EQ(cache_folder(), std::nullopt);
  }
}

}  // namespace
}  // namespace fretval::cache_folder_test
