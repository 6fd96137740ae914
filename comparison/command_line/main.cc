#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

#include "comparison/case/case.h"
#include "comparison/command_line/commands.h"
#include "comparison/command_line/exit_codes.h"
#include "comparison/command_line/interrupt.h"
#include "comparison/support/escape.h"
#include "comparison/support/log.h"
#include "comparison/support/versions.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace {

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : fretval::versions()) text += fmt::format("{} {}\n", name, version);
  text.pop_back();
  return text;
}

/// Parts of a message may come from a file.
void say(const std::exception& error) {
  fretval::log::error(fretval::without_control_characters(error.what()));
}

/// Every body takes hundreds of megabytes and gives them back. Where they go back to the kernel and come anew, clearing
/// their pages is a tenth of the time of a worn profile.
void keep_memory_of_bodies() {
  constexpr int one_gigabyte = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, one_gigabyte);
  mallopt(M_TRIM_THRESHOLD, one_gigabyte);
}

int run(int argc, char** argv) {
  keep_memory_of_bodies();
  fretval::log::start();
  fretval::say_on_interrupt("interrupted: nothing is kept");
  CLI::App app{
      "fretval: do finite elements confirm what the method of dimensionality reduction predicts for fretting on an "
      "elastomer, how closely, and at what cost?"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  fretval::Command command;
  fretval::add_commands(app, command);
  if (argc == 1) {
    fmt::print(stderr, "{}", app.help());
    return fretval::exit_bad_input;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const auto unknown = fretval::unknown_verb(app, {argv + 1, argv + argc});
    if (error.get_exit_code() == 0 || unknown.empty())
      return app.exit(error) == 0 ? fretval::exit_agree : fretval::exit_bad_input;
    say(fretval::InputError(unknown));
    return fretval::exit_bad_input;
  }
  try {
    const int exit_code = command();
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw std::system_error(errno ? errno : EIO, std::generic_category(), "cannot write to the standard output");
    return exit_code;
  } catch (const fretval::InputError& error) {
    say(error);
    return fretval::exit_bad_input;
  } catch (const fretval::meshes::MeshError& error) {
    say(error);
    return fretval::exit_bad_input;
  } catch (const fretval::fem::SolverError& error) {
    say(error);
    return fretval::exit_numerics_failed;
  } catch (const std::filesystem::filesystem_error& error) {
    say(error);
    return fretval::exit_system_failed;
  } catch (const std::system_error& error) {
    say(error);
    return fretval::exit_system_failed;
  } catch (const std::runtime_error& error) {
    say(error);
    return fretval::exit_numerics_failed;
  } catch (const std::bad_alloc&) {
    fretval::log::error("out of memory: use a larger Accuracy / Tolerance");
    return fretval::exit_system_failed;
  } catch (const std::exception& error) {
    say(error);
    return fretval::exit_system_failed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (...) {  // from a message
    std::fputs("error: fretval ended before it could say why\n", stderr);
    return fretval::exit_system_failed;
  }
}
