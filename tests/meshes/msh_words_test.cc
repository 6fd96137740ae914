#include "meshes/msh_words.h"

#include <gtest/gtest.h>

#include "tests/meshes/expect_error.h"
#include "tests/meshes/scratch_folder.h"

namespace fretval::meshes::msh_words_test {
namespace {

class MshWords : public testing::Test {
 protected:
  Words words(const std::string& text) {
    write_text(file, text);
    return Words(file);
  }

  /// Expects an error "FILE, line N: what is value, must be valid" from an action on the words of a text.
  template <typename Action>
  void expect_failure(const std::string& text, const Action& action, const std::string& message) {
    expect_error(
        [&] {
          Words of_text = words(text);
          action(of_text);
        },
        {file.string() + message});
  }

  ScratchFolder folder;
  std::filesystem::path file = folder / "words.msh";
};

TEST_F(MshWords, AreSeparatedByBlanksAndLineEndings) {
  Words text = words("  $Nodes\r\n-3\t1e-3\n\"two words\"\"\" end \n");
  text.expect("$Nodes");
  EXPECT_EQ(text.integer("n"), -3);
  EXPECT_EQ(text.real("x"), 1e-3);
  EXPECT_EQ(text.quoted("name"), "two words");
  EXPECT_EQ(text.quoted("name"), "");
  EXPECT_FALSE(text.at_end());
  EXPECT_EQ(text.next("word"), "end");
  EXPECT_TRUE(text.at_end());
}

TEST_F(MshWords, FailuresNameTheLineOfTheWord) {
  const auto two_words = [](Words& text) {
    text.next("first");
    text.expect("c");
  };
  expect_failure("a\nb\nc", two_words, ", line 2: the next word is b, must be c");
  expect_failure("a b\nc", two_words, ", line 1: the next word is b, must be c");
  expect_failure("\n\na\n\nb", two_words, ", line 5: the next word is b, must be c");
}

TEST_F(MshWords, EndTooEarly) {
  const auto past_the_end = [](Words& text) {
    text.next("first");
    text.next("the type");
  };
  expect_failure("a", past_the_end, ", line 1: the type is missing, must be there: the file ends too early");
}

TEST_F(MshWords, NumbersMustBeNumbersToTheirEnd) {
  for (const std::string word : {"1.5", "2x", "0x10", "99999999999999999999", "one", "-"})
    expect_failure(
        word, [](Words& text) { text.integer("n"); }, ", line 1: n is " + word + ", must be a whole number");
  for (const std::string word : {"1,5", "2.0.0", "1e400", "one", "1e"})
    expect_failure(
        word, [](Words& text) { text.real("x"); }, ", line 1: x is " + word + ", must be a number");
}

// After the number, " ab" are three characters.
TEST_F(MshWords, CountsReachFromZeroToWhatTheFileCanHold) {
  EXPECT_EQ(words("0").count("n"), 0U);
  EXPECT_EQ(words("3 ab").count("n"), 3U);
  const auto count = [](Words& text) { text.count("n"); };
  expect_failure("4 ab", count, ", line 1: n is 4, must be between 0 and what the rest of the file can hold, 3");
  expect_failure("-1 ab", count, ", line 1: n is -1, must be between 0 and what the rest of the file can hold, 3");
}

TEST_F(MshWords, NamesMustHaveBothQuotes) {
  const auto quoted = [](Words& text) { text.quoted("a name"); };
  expect_failure("body", quoted, ", line 1: a name is body, must be in double quotes");
  expect_failure("\"body", quoted, ", line 1: a name is without end, must be in double quotes");
  expect_failure("\"", quoted, ", line 1: a name is without end, must be in double quotes");
}

TEST_F(MshWords, MustBeInAFileWithText) {
  expect_error([&] { Words(folder / "none.msh"); }, {"none.msh: no such file"});
  expect_error([&] { words(" \n\t"); }, {file.string() + ": has 3 characters, none but blanks"});
  std::filesystem::create_directory(folder / "folder.msh");
  expect_error([&] { Words(folder / "folder.msh"); }, {"folder.msh: cannot be opened"});
}

}  // namespace
}  // namespace fretval::meshes::msh_words_test
