#include "comparison/support/content_hash.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

// Values of the authors' own table.
TEST(ContentHash, IsThatOfFowlerNollAndVo) {
  EXPECT_EQ(content_hash(""), "cbf29ce484222325-0");
  EXPECT_EQ(content_hash("a"), "af63dc4c8601ec8c-1");
  EXPECT_EQ(content_hash("foobar"), "85944171f73967e8-6");
}

TEST(ContentHash, TellsBytesApart) {
  EXPECT_NE(content_hash("1 0 0"), content_hash("1 0 1"));
  EXPECT_NE(content_hash(std::string("\0", 1)), content_hash(""));
}

}  // namespace
}  // namespace fretval
