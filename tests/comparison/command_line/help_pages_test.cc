#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "comparison/command_line/commands.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::help_pages_test {
namespace {

TEST(HelpPages, TheManualHasEveryVerbAndItsOptions) {
  const ScratchFolder folder;
  const auto page = fretval_run("pages man", folder).out;
  expect_parts(page, {".TH FRETVAL 1\n", ".SS run\n", ".B \\-o,\\-\\-output \\fR\\fIVALUE\\fR\n", ".SS trade\n",
                      ".SH EXIT STATUS\n"});
  EXPECT_EQ(page.find(".SS pages"), std::string::npos);
}

TEST(HelpPages, BashCompletesVerbsOptionsAndFiles) {
  const ScratchFolder folder;
  const auto script = folder.write("completion", fretval_run("pages bash", folder).out);
  folder.write("case.prm", "");
  const auto completed = [&](const std::string& words, int at) {
    return shell_run("cd " + quoted(folder.path()) + "; bash -c 'source " + script.string() + "; COMP_WORDS=(" + words +
                         "); COMP_CWORD=" + std::to_string(at) + "; _fretval; echo \"${COMPREPLY[@]}\"'",
                     folder)
        .out;
  };
  EXPECT_EQ(completed("fretval expl", 1), "explain\n");
  EXPECT_EQ(completed("fretval run --ju", 2), "--junit\n");
  EXPECT_EQ(completed("fretval run cas", 2), "case.prm\n");
  EXPECT_EQ(completed("fretval --quiet ch", 2), "check\n");
}

// Scripts go by them: the help, the manual and the page of the docs.
TEST(HelpPages, NameEveryExitCode) {
  const ScratchFolder folder;
  const auto help = fretval_run("--help", folder).out, manual = fretval_run("pages man", folder).out,
             page = text_of(std::filesystem::path(FRETVAL_SOURCE_DIR) / "docs/commands.md");
  const std::map<int, const char*> meanings{{0, "all that was asked for agrees"},
                                            {1, "finite elements and MDR disagree"},
                                            {2, "bad input"},
                                            {3, "the numerics failed"},
                                            {4, "the system failed"},
                                            {5, "not resolved: "}};
  for (const auto& [code, meaning] : meanings) {
    const auto number = std::to_string(code);
    expect_parts(help, {"\n" + number + "  " + meaning});
    expect_parts(manual, {"\n.TP\n" + number + "\n" + meaning});
    expect_parts(page, {"\n| " + number + " | " + meaning});
  }
}

}  // namespace
}  // namespace fretval::help_pages_test
