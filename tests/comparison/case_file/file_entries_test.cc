#include "comparison/case_file/file_entries.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "comparison/case_file/case_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::file_entries_test {
namespace {

/// Everything that is wrong with a text.
std::string problems_of(const std::string& text) {
  Problems problems;
  read_prm(text, "a.prm", problems);
  return refusal([&] { problems.throw_if_any(); });
}

TEST(PrmEntries, AreReadWithoutCommentsAndAcrossLines) {
  Problems problems;
  const auto prm = read_prm(
      "subsection Friction # one\n\n  set  Coefficient \\\n = 0.5 # a = b\nEND\nSubsection  Motion\r\n"
      "  set Normal   frequency=2 Hz\r\nset Path = a=b.csv\n  set Phase =\nend\n",
      "a.prm", problems);
  EXPECT_TRUE(problems.messages.empty());
  EXPECT_TRUE(prm.included.empty());
  EXPECT_EQ(prm.entries.text("Friction", "Coefficient"), "0.5");
  EXPECT_EQ(prm.entries.text("Motion", "Normal frequency"), "2 Hz");
  EXPECT_EQ(prm.entries.text("Motion", "Path"), "a=b.csv");
  EXPECT_EQ(prm.entries.text("Motion", "Phase"), "");
  EXPECT_EQ(prm.entries.text("Friction", "Law"), "");
}

TEST(PrmEntries, ThatThereAreNotAreSaidOnce) {
  const auto message = problems_of(
      "subsection Fiction\n  set Coefficient = 1\nend\nsubsection Wear\n  set Speed = 1\n  set Cycles = 2\nend\n");
  expect_parts(message, {"a.prm: line 1: subsection Fiction", "did you mean Friction?", "a.prm: line 5: Wear / Speed"});
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
}

TEST(PrmEntries, AreNotSetTwice) {
  expect_parts(problems_of("subsection Wear\nset Cycles = 1\nend\nsubsection Wear\nset Cycles = 2\nend\n"),
               {"a.prm: line 5: Wear / Cycles", "first in line 2"});
}

TEST(PrmEntries, AreReadOnAfterALineThatIsNotUnderstood) {
  for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
           {"subsection Wear\nCycles = 1\nend\n", "line 2: Cycles = 1: expected set ENTRY = VALUE"},
           {"subsection Wear\nset Cycles 1\nend\n", "line 2: set Cycles 1: expected set ENTRY = VALUE"},
           {"subsection\nend\n", "line 1: subsection: expected"},
           {"subsection Wear\nend Wear\nend\n", "line 2: end Wear: expected"},
           {"subsection Wear\nend\nend\n", "line 3: end: there is no subsection"},
           {"set Cycles = 1\n", "line 1: set Cycles: every entry stands within a subsection"},
           {"subsection Motion\nsubsection Wear\nend\n",
            "line 2: subsection Wear stands within subsection Motion of line 1"}}) {
    Problems problems;
    const auto prm = read_prm(text + "subsection Friction\nset Coefficient = 0.5\nend\n", "a.prm", problems);
    EXPECT_EQ(prm.entries.text("Friction", "Coefficient"), "0.5") << text;
    EXPECT_TRUE(problems.has_unread_lines) << text;
    expect_parts(fmt::format("{}", fmt::join(problems.messages, "\n")), {"a.prm: " + problem});
  }
  expect_parts(problems_of("subsection Wear\n\n"), {"a.prm: line 2: subsection Wear of line 1 has no end"});
}

TEST(JsonEntries, EverythingThatIsWrongIsSaid) {
  const ScratchFolder folder;
  const auto file = folder.write("a.json", R"({"Elastomer": {"Rheology": "prony", "Branch moduli": [1e6, "-2 MPa"]},
    "Frition": {"Coefficient": 1}, "Wear": {"Cycles": null, "Speed": 1}})");
  expect_parts(
      refusal([&] { read_case_file(file); }),
      {"Elastomer / Branch moduli = 1000000.0, -2 MPa: expected a list", "a.json: subsection Frition: no such",
       "did you mean Friction?", "a.json: Wear / Cycles: must be text", "a.json: Wear / Speed: no such entry"});
}

}  // namespace
}  // namespace fretval::file_entries_test
