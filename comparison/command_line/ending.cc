#include "comparison/command_line/ending.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <new>
#include <system_error>

#include "comparison/case/case.h"
#include "comparison/support/log.h"
#include "comparison/support/ranks.h"
#include "comparison/support/text.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

/// Parts of a message may come from a file.
int say(const std::exception& error, int exit_code) {
  log::error(rank_text() + without_control_characters(error.what()));
  return exit_code;
}

// A handler may touch nothing that allocates.
std::array<char, 1000> text;
volatile std::sig_atomic_t n_characters = 0;

void say_and_end(int signal) {
  const auto written = write(STDERR_FILENO, text.data(), static_cast<std::size_t>(n_characters));
  static_cast<void>(written);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

int say_failure(const std::exception_ptr& why) {
  try {
    std::rethrow_exception(why);
  } catch (const InputError& error) {
    return say(error, exit_bad_input);
  } catch (const meshes::MeshError& error) {
    return say(error, exit_bad_input);
  } catch (const fem::SolverError& error) {
    return say(error, exit_numerics_failed);
  } catch (const std::system_error& error) {  // std::filesystem::filesystem_error is one
    return say(error, exit_system_failed);
  } catch (const std::runtime_error& error) {
    return say(error, exit_numerics_failed);
  } catch (const std::bad_alloc&) {
    log::error(rank_text() + "out of memory: use a larger Accuracy / Tolerance");
    return exit_system_failed;
  } catch (const std::exception& error) {
    return say(error, exit_system_failed);
  }
}

int end_with_failure(const std::exception_ptr& why) {
  let_first_rank_speak();
  const int exit_code = say_failure(why);
  end_all_ranks(exit_code);
  return exit_code;
}

void say_on_interrupt(const std::string& message) {
  const auto line = "\n" + message + "\n";
  n_characters = 0;
  const auto n = std::min(line.size(), text.size());
  std::copy_n(line.begin(), n, text.begin());
  n_characters = static_cast<std::sig_atomic_t>(n);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, say_and_end);
}

}  // namespace fretval
