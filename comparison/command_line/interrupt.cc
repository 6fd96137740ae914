#include "comparison/command_line/interrupt.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>

namespace fretval {
namespace {

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

void say_on_interrupt(const std::string& message) {
  const auto line = "\n" + message + "\n";
  n_characters = 0;
  const auto n = std::min(line.size(), text.size());
  std::copy_n(line.begin(), n, text.begin());
  n_characters = static_cast<std::sig_atomic_t>(n);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, say_and_end);
}

}  // namespace fretval
