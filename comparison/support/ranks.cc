#include "comparison/support/ranks.h"

#include <fmt/format.h>
#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <stdexcept>
#include <thread>

#include "fem/support/processes.h"

namespace fretval {
namespace {

constexpr int question_tag = 1, order_tag = 2, first_answer_tag = 3, n_answer_tags = 30000;

void send(const std::string& text, int to, int tag) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD, &request);
  for (int done = 0; !done;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) rest();
  }
}

struct Message {
  int rank;
  std::string text;
};

std::optional<Message> next_message(int from, int tag) {
  int found = 0, n_bytes = 0;
  MPI_Message handle = MPI_MESSAGE_NULL;
  MPI_Status status;
  MPI_Improbe(from, tag, MPI_COMM_WORLD, &found, &handle, &status);
  if (!found) return std::nullopt;
  MPI_Get_count(&status, MPI_BYTE, &n_bytes);
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(n_bytes), '\0')};
  MPI_Mrecv(message.text.data(), n_bytes, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
  return message;
}

bool mpi_runs() {
  int is_started = 0, is_over = 0;
  MPI_Initialized(&is_started);
  MPI_Finalized(&is_over);
  return is_started && !is_over;
}

std::vector<int> own_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

void keep_to(const std::vector<int>& cores) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int core : cores) CPU_SET(core, &set);
  sched_setaffinity(0, sizeof set, &set);
}

void share_out_cores() {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  int number = 0, count = 1;
  MPI_Comm_rank(node, &number);
  MPI_Comm_size(node, &count);
  std::array<char, CPU_SETSIZE> own{};
  for (const int core : own_cores()) own[static_cast<std::size_t>(core)] = 1;
  std::vector<char> all(static_cast<std::size_t>(count) * own.size());
  MPI_Allgather(own.data(), CPU_SETSIZE, MPI_CHAR, all.data(), CPU_SETSIZE, MPI_CHAR, node);
  MPI_Comm_free(&node);
  std::vector<std::vector<int>> cores(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i]) cores[i / own.size()].push_back(static_cast<int>(i % own.size()));
  keep_to(share_of_cores(cores, static_cast<std::size_t>(number)));
}

std::string host_name() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

}  // namespace

void rest(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

Ranks::Ranks() {
  if (!are_several_ranks()) return;
  int provided = MPI_THREAD_SINGLE;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
  if (provided < MPI_THREAD_MULTIPLE) throw std::runtime_error("this MPI does not let several threads talk");
  MPI_Comm_rank(MPI_COMM_WORLD, &number_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  share_out_cores();
}

Ranks::~Ranks() {
  if (are_several() && std::uncaught_exceptions() == 0 && mpi_runs()) MPI_Finalize();
}

std::vector<long> Ranks::sum(std::vector<long> values) const {
  if (are_several())
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  return values;
}

void Ranks::tell(const std::string& message) const {
  send("0 " + message, 0, question_tag);
}

std::string Ranks::ask(const std::string& question) const {
  static std::atomic<int> n_asked{0};
  const int tag = first_answer_tag + n_asked++ % n_answer_tags;
  send(fmt::format("{} {}", tag, question), 0, question_tag);
  while (true) {
    if (auto message = next_message(0, tag)) return std::move(message->text);
    rest();
  }
}

std::optional<Ranks::Question> Ranks::next_question() const {
  auto message = next_message(MPI_ANY_SOURCE, question_tag);
  if (!message) return std::nullopt;
  const auto blank = message->text.find(' ');
  return Question{message->rank, std::stoi(message->text.substr(0, blank)), message->text.substr(blank + 1)};
}

void Ranks::answer(const Question& question, const std::string& text) const {
  send(text, question.rank, question.answer_tag);
}

void Ranks::order(const std::string& text) const {
  for (int rank = 1; rank < count_; ++rank) send(text, rank, order_tag);
}

std::optional<std::string> Ranks::next_order() const {
  auto message = next_message(0, order_tag);
  if (!message) return std::nullopt;
  return std::move(message->text);
}

bool are_several_ranks() {
  return fem::this_process().count > 1;
}

bool is_first_rank() {
  return fem::this_process().number == 0;
}

std::string rank_text() {
  const auto process = fem::this_process();
  return process.count > 1 ? fmt::format("rank {} of {} on {}: ", process.number, process.count, host_name()) : "";
}

void let_first_rank_speak() {
  if (!is_first_rank()) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void end_all_ranks(int exit_code) {
  if (are_several_ranks() && mpi_runs()) MPI_Abort(MPI_COMM_WORLD, exit_code);
}

std::vector<int> share_of_cores(const std::vector<std::vector<int>>& cores, std::size_t rank) {
  const auto& own = cores[rank];
  std::vector<int> share;
  std::vector<std::size_t> sharers;
  for (std::size_t i = 0; i < own.size(); ++i) {
    sharers.clear();
    for (std::size_t other = 0; other < cores.size(); ++other)
      if (std::binary_search(cores[other].begin(), cores[other].end(), own[i])) sharers.push_back(other);
    if (sharers[i * sharers.size() / own.size()] == rank) share.push_back(own[i]);
  }
  if (share.empty() && !own.empty()) share.push_back(own[rank % own.size()]);
  return share;
}

Shares::Shares(std::size_t n, std::size_t n_ranks) {
  for (std::size_t rank = 0; rank < n_ranks; ++rank)
    stretches_.push_back({n * rank / n_ranks, n * (rank + 1) / n_ranks});
}

std::optional<std::size_t> Shares::next(std::size_t rank, bool from_front) {
  auto& own = stretches_[rank];
  if (own.size() > 0) return from_front ? own.front++ : --own.back;
  auto& longest = *std::max_element(stretches_.begin(), stretches_.end(),
                                    [](const Stretch& a, const Stretch& b) { return a.size() < b.size(); });
  if (longest.size() == 0) return std::nullopt;
  return --longest.back;
}

}  // namespace fretval
