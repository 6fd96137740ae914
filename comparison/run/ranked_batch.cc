#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "comparison/reference/normal_responses.h"
#include "comparison/run/batch.h"
#include "comparison/run/estimate.h"
#include "comparison/simulation/bodies/distributed_body.h"
#include "comparison/support/parallel.h"
#include "comparison/support/ranks.h"

namespace fretval {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ToleranceUse, share, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BatchLine, name, outcome, failure, largest_use, answer, json, seconds)

namespace {

// First letters of what the first rank is asked or told.
constexpr char next_case = 'c', body = 'b', no_more_threads = 'n';
// The first rank seldom orders anything: a body that is to be made together, or, by an empty order, the end.
constexpr int between_orders = 10;  // ms
const std::string end;

/// Lines with the numbers of their cases; the numbers of work beside the cases follow these, and of their lines only
/// the json is set.
using DoneWork = std::vector<std::pair<std::size_t, BatchLine>>;

/// The lines as bytes in CBOR, as messages may contain bytes that are not UTF-8.
std::string packed(const DoneWork& done) {
  std::string bytes;
  nlohmann::json::to_cbor(done, bytes);
  return bytes;
}

/// The first rank's side: who computes what, and what has come of it.
class Desk {
 public:
  Desk(const std::vector<PreparedCase>& cases, const BatchOptions& options, const Ranks& ranks)
      : cases_(cases),
        options_(options),
        ranks_(ranks),
        shares_(cases.size(), static_cast<std::size_t>(ranks.count())),
        lines_(cases.size()),
        expected_(estimated_seconds(cases, options.proof, 1)) {}

  /// Answers a question. Returns whether there was one.
  bool serve() {
    const auto question = ranks_.next_question();
    if (!question) return false;
    const auto text = question->text.substr(1);
    switch (question->text.front()) {
      case next_case:
        take(text.substr(1));
        ranks_.answer(*question, next_for(question->rank, text.front()));
        break;
      case body:
        ranks_.answer(*question, body_for(text));
        break;
      default:
        ++n_done_ranks_;
    }
    return true;
  }

  [[nodiscard]] bool all_ranks_are_done() const { return n_done_ranks_ == ranks_.count(); }
  std::vector<BatchLine> take_lines() { return std::move(lines_); }

 private:
  void take(const std::string& bytes) {
    for (auto& [number, line] : nlohmann::json::from_cbor(bytes).get<DoneWork>()) {
      if (number < cases_.size())
        take_case(number, std::move(line));
      else
        options_.beside.take(number - cases_.size(), std::move(line.json));
    }
  }

  void take_case(std::size_t number, BatchLine line) {
    if (line.name != cases_.at(number).input.name)
      throw std::logic_error(
          fmt::format("the ranks do not read the same cases: {} is not {}", line.name, cases_[number].input.name));
    expected_seconds_ += expected_.at(line.name);
    seconds_ += line.seconds;
    lines_[number] = std::move(line);
    options_.progress(lines_[number]);
  }

  /// Numbers of work that is expected to take about a quarter of a second, and less towards the end; empty: all is
  /// handed out.
  std::string next_for(int rank, char end_of_stretch) {
    constexpr double enough = 0.25;  // s, of which to wait for an answer, a rest or two on either side, is a hundredth
    const auto n_left = cases_.size() + options_.beside.n - n_handed_out_;
    const auto fair = std::max<std::size_t>(1, n_left / (4 * n_cores() * static_cast<std::size_t>(ranks_.count())));
    const double per_expected = expected_seconds_ > 0 ? seconds_ / expected_seconds_ : 1;
    std::string numbers;
    double seconds = 0;
    for (std::size_t i = 0; i < std::min(fair, n_left) && seconds < enough; ++i) {
      const auto number = next_number(rank, end_of_stretch);
      numbers += fmt::format("{} ", number);
      ++n_handed_out_;
      if (number < cases_.size()) seconds += per_expected * expected_.at(cases_[number].input.name);
    }
    return numbers;
  }

  std::size_t next_number(int rank, char end_of_stretch) {
    const auto number = shares_.next(static_cast<std::size_t>(rank), end_of_stretch == '0');
    return number ? *number : n_handed_out_;  // beside the cases
  }

  const std::string& body_for(const std::string& specification) {
    const auto [made, is_new] = bodies_.try_emplace(specification);
    if (is_new) {
      ranks_.order(specification);
      made->second = operators_made_together(specification, {0, static_cast<unsigned>(ranks_.count())});
    }
    return made->second;
  }

  const std::vector<PreparedCase>& cases_;
  const BatchOptions& options_;
  const Ranks& ranks_;
  Shares shares_;
  std::vector<BatchLine> lines_;
  std::map<std::string, double> expected_;     // seconds, of each case by its name
  double expected_seconds_ = 0, seconds_ = 0;  // of those that are done, and that they have taken
  std::size_t n_handed_out_ = 0;
  std::map<std::string, std::string> bodies_;
  int n_done_ranks_ = 0;
};

/// Obeys one of the first rank's orders, if there is any. Returns false at the end.
bool obey(const Ranks& ranks, bool& did_something) {
  const auto order = ranks.next_order();
  did_something = order.has_value();
  if (!order) return true;
  if (*order == end) return false;
  operators_made_together(*order, {static_cast<unsigned>(ranks.number()), static_cast<unsigned>(ranks.count())});
  return true;
}

BatchLine beside_line(const BesideCases& beside, std::size_t number) {
  BatchLine line;
  line.json = beside.compute(number);
  return line;
}

}  // namespace

std::vector<BatchLine> run_ranked_batch(const std::vector<PreparedCase>& cases, const BatchOptions& options,
                                        BodyStore& bodies, const Ranks& ranks, std::size_t from_dofs,
                                        const std::function<void(const std::exception_ptr&)>& give_up) {
  bodies.distribution =
      Distribution{from_dofs, ranks.count(), [&](const std::string& wanted) { return ranks.ask(body + wanted); }};
  NormalResponses references;
  const auto compute = [&](std::size_t thread) {
    DoneWork done;
    while (true) {
      std::istringstream numbers(ranks.ask(fmt::format("{}{}{}", next_case, thread % 2, packed(done))));
      done.clear();
      for (std::size_t i = 0; numbers >> i;)
        done.emplace_back(i, i < cases.size() ? computed_line(cases[i], options, bodies, references)
                                              : beside_line(options.beside, i - cases.size()));
      if (done.empty()) return;
    }
  };
  // This thread talks, answers and makes what is made together; the others compute.
  std::thread crew([&] {
    for_each_in_parallel(n_cores(), [&](std::size_t thread) {
      try {
        compute(thread);
      } catch (...) {
        give_up(std::current_exception());
      }
    });
    ranks.tell(std::string(1, no_more_threads));
  });
  std::vector<BatchLine> lines;
  try {
    if (ranks.is_first()) {
      Desk desk(cases, options, ranks);
      while (!desk.all_ranks_are_done())
        if (!desk.serve()) rest();
      ranks.order(end);
      lines = desk.take_lines();
    } else {
      for (bool did_something = true; obey(ranks, did_something);)
        if (!did_something) rest(between_orders);
    }
  } catch (...) {
    give_up(std::current_exception());
  }
  crew.join();
  return lines;
}

}  // namespace fretval
