#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/comparison/program_server.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {

/// What a run of the program came to.
struct Run {
  int exit_code;
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A word of a shell command, whatever it is made of.
inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs a shell command with the outputs in files of a folder.
inline Run shell_run(const std::string& command, const ScratchFolder& folder) {
  const auto out = folder.path() / "stdout.txt", err = folder.path() / "stderr.txt";
  const int status = std::system(("{ " + command + "; } >" + out.string() + " 2>" + err.string()).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

/// Runs the program, faster than a shell would: see program_server.h.
inline Run fretval_run(const std::string& arguments, const ScratchFolder& folder) {
  const auto out = folder.path() / "stdout.txt", err = folder.path() / "stderr.txt";
  const int exit_code = served_exit_code(arguments, out, err);
  return {exit_code, text_of(out), text_of(err)};
}

}  // namespace fretval
