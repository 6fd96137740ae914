#include "mdr/support/text_lines.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace fretval::mdr::text_lines_test {
namespace {

std::vector<std::string> texts_of(const std::string& bytes) {
  std::istringstream stream(bytes);
  std::vector<std::string> texts;
  for (const auto& line : read_lines(stream, "a.txt")) {
    EXPECT_EQ(line.number, static_cast<int>(texts.size()) + 1);
    texts.push_back(line.text);
  }
  return texts;
}

using Texts = std::vector<std::string>;

TEST(TextLines, EndAsOnAnySystem) {
  for (const std::string end : {"\n", "\r\n", "\r"})
    EXPECT_EQ(texts_of("a" + end + end + "b" + end), (Texts{"a", "", "b"}));
  EXPECT_EQ(texts_of("a\nb"), (Texts{"a", "b"}));
  EXPECT_EQ(texts_of(""), Texts{});
}

TEST(TextLines, AreUtf8WhateverTheyWere) {
  EXPECT_EQ(texts_of("\xEF\xBB\xBFT [\xC2\xB0"
                     "C]\n"),
            (Texts{"T [\u00b0C]"}));
  EXPECT_EQ(texts_of("T [\xB0"
                     "C];d [\xB5m];G\x92\n"),
            (Texts{"T [\u00b0C];d [\u00b5m];G'"}));
  EXPECT_EQ(texts_of(std::string("\xFF\xFE"
                                 "d\0 \0\xB5\0m\0\n\0"
                                 "1\0",
                                 14)),
            (Texts{"d \u00b5m", "1"}));
  EXPECT_EQ(texts_of(std::string("\xFE\xFF\0d\0\n\0001", 8)), (Texts{"d", "1"}));
}

// C0 and C1 begin no character of UTF-8, and are letters of Latin 1.
TEST(TextLines, OfBytesThatUtf8DoesNotHaveAreLatin1) {
  EXPECT_EQ(texts_of("\xC0\xAF;\xC1\xBF\n"), (Texts{"\u00c0\u00af;\u00c1\u00bf"}));
}

TEST(TextLines, RefuseWhatIsNoText) {
  EXPECT_THROW(texts_of(std::string("a\nb\0c", 5)), std::invalid_argument);
  EXPECT_THROW(texts_of(std::string(20'000, 'x')), std::invalid_argument);
  std::istringstream stream("a");
  stream.setstate(std::ios::failbit);
  EXPECT_THROW(read_lines(stream, "a.txt"), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::text_lines_test
