#include "comparison/command_line/program.h"

#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/command_line/commands.h"
#include "comparison/command_line/ending.h"
#include "comparison/support/log.h"
#include "comparison/support/ranks.h"
#include "comparison/support/versions.h"

namespace fretval {
namespace {

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
  text.pop_back();
  return text;
}

/// Message on a command line that is wrong: what was probably mistyped, otherwise the words of the library.
std::string what_is_wrong(const CLI::App& app, const std::vector<std::string>& arguments, const std::string& said) {
  auto text = unknown_verb(app, arguments);
  if (text.empty()) text = unknown_option(app, arguments);
  if (!text.empty()) return text;
  const auto verbs = app.get_subcommands();
  const auto command = "fretval" + (verbs.empty() ? "" : " " + verbs.front()->get_name());
  return fmt::format("{0}: {1}; {0} --help says more", command, said);
}

/// Every body takes hundreds of megabytes and gives them back. Where they go back to the kernel and come anew, clearing
/// their pages is a tenth of the time of a worn profile.
void keep_memory_of_bodies() {
  constexpr int one_gigabyte = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, one_gigabyte);
  mallopt(M_TRIM_THRESHOLD, one_gigabyte);
}

}  // namespace

int run_program(int argc, char** argv) {
  keep_memory_of_bodies();
  log::start();
  if (is_first_rank()) say_on_interrupt("interrupted: nothing is kept");
  CLI::App app{
      "fretval: do finite elements confirm what the method of dimensionality reduction predicts for fretting on an "
      "elastomer, how closely, and at what cost?\nThe method of dimensionality reduction (MDR): V. L. Popov and M. "
      "Hess, Method of Dimensionality Reduction in Contact Mechanics and Friction, Springer 2015."};
  app.set_version_flag("--version", version_text());
  app.footer(fmt::format("Exit codes:\n{}", exit_codes_text));
  app.require_subcommand(1);
  Command command;
  add_commands(app, command);
  if (argc == 1) {
    fmt::print(stderr, "{}", app.help());
    return exit_bad_input;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return say_failure(std::make_exception_ptr(InputError(what_is_wrong(app, {argv + 1, argv + argc}, error.what()))));
  }
  try {
    if (are_several_ranks() && !app.got_subcommand("run"))
      throw InputError(fmt::format("{}: works in one process; mpirun is for fretval run alone", argv[1]));
    const int exit_code = command();
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw std::system_error(errno ? errno : EIO, std::generic_category(), "cannot write to the standard output");
    return exit_code;
  } catch (...) {
    return end_with_failure(std::current_exception());
  }
}

}  // namespace fretval
