#include "tests/comparison/program_server.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "comparison/command_line/program.h"

namespace fretval {
namespace {

/// A message between processes is one packet: texts, each with the zero at its end.
using Packet = std::vector<char>;

void append(Packet& packet, const std::string& text) {
  packet.insert(packet.end(), text.c_str(), text.c_str() + text.size() + 1);
}

std::vector<char*> texts_of(Packet& packet) {
  std::vector<char*> texts;
  for (std::size_t i = 0; i < packet.size(); i += std::char_traits<char>::length(&packet[i]) + 1)
    texts.push_back(&packet[i]);
  return texts;
}

void write_to(const char* file, int descriptor) {
  dup2(open(file, O_WRONLY | O_CREAT | O_TRUNC, 0666), descriptor);
}

/// In a process of its own. Texts: both outputs, how many words, these, and the environment.
[[noreturn]] void run(Packet packet) {
  auto texts = texts_of(packet);
  write_to(texts[0], STDOUT_FILENO);
  write_to(texts[1], STDERR_FILENO);
  const auto end_of_words = texts.begin() + 3 + std::atoi(texts[2]);
  std::vector<char*> words(texts.begin() + 3, end_of_words);
  clearenv();
  for (auto variable = end_of_words; variable != texts.end(); ++variable) putenv(*variable);
  words.push_back(nullptr);
  std::exit(run_program(static_cast<int>(words.size()) - 1, words.data()));
}

/// Until there is nobody any more who could ask.
[[noreturn]] void serve(int socket) {
  Packet packet(1 << 20);
  for (ssize_t n; (n = recv(socket, packet.data(), packet.size(), 0)) > 0;) {
    const pid_t child = fork();
    if (child == 0) run({packet.begin(), packet.begin() + n});
    int status = -1;
    waitpid(child, &status, 0);
    send(socket, &status, sizeof status, 0);
  }
  _exit(EXIT_SUCCESS);
}

int started() {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "no socket for the program server");
  if (fork() == 0) {
    close(sockets[0]);
    serve(sockets[1]);
  }
  close(sockets[1]);
  return sockets[0];
}

int socket_of_server() {
  static const int socket = started();
  return socket;
}

}  // namespace

void start_program_server() {
  socket_of_server();
}

int served_exit_code(const std::string& words, const std::string& out, const std::string& err) {
  wordexp_t command;
  if (wordexp(("fretval " + words).c_str(), &command, 0) != 0) throw std::invalid_argument(words);
  Packet packet;
  for (const auto& text : {out, err, std::to_string(command.we_wordc)}) append(packet, text);
  for (std::size_t i = 0; i < command.we_wordc; ++i) append(packet, command.we_wordv[i]);
  for (char** variable = environ; *variable; ++variable) append(packet, *variable);
  wordfree(&command);
  const int socket = socket_of_server();
  int status = -1;
  if (send(socket, packet.data(), packet.size(), 0) < 0 || recv(socket, &status, sizeof status, 0) <= 0)
    throw std::system_error(errno, std::generic_category(), "no answer from the program server");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace fretval
