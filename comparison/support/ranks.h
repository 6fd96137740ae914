#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fretval {

/// Sleeps for some milliseconds between two looks for messages.
void rest(int milliseconds = 1);

/// The processes that mpirun has started for one run, and how they talk. With petsc_session.cc and
/// distributed_condensation.cc the only place that knows of MPI.
///
/// The first rank answers questions and gives orders. Any thread of any rank asks (the first rank's too); one thread of
/// the first answers, and one of each other looks for orders. Waiting ranks sleep between looks, so that they take no
/// core from those that compute.
class Ranks {
 public:
  /// Starts MPI where this process was started with others; alone it is the first and only rank, and there is no MPI.
  /// Ranks that may run on the same cores of a node share them out, before they have any threads. Throws
  /// std::runtime_error if this MPI does not let threads talk.
  Ranks();
  /// Waits for the other ranks, unless an exception is on its way, of which they do not know.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] bool is_first() const { return number_ == 0; }
  [[nodiscard]] bool are_several() const { return count_ > 1; }

  /// Sums over all ranks, on all of them; all call it at the same time.
  [[nodiscard]] std::vector<long> sum(std::vector<long> values) const;

  /// Sends a message to the first rank; asks it and waits for the answer.
  void tell(const std::string& message) const;
  [[nodiscard]] std::string ask(const std::string& question) const;

  struct Question {
    int rank;
    int answer_tag;  ///< 0: no answer is expected
    std::string text;
  };
  /// For the first rank: the next question or message of any rank, if there is one; the answer to a question; an order
  /// to all other ranks.
  [[nodiscard]] std::optional<Question> next_question() const;
  void answer(const Question& question, const std::string& text) const;
  void order(const std::string& text) const;
  /// For the other ranks: the next order, if there is one.
  [[nodiscard]] std::optional<std::string> next_order() const;

 private:
  int number_ = 0, count_ = 1;
};

/// Whether several ranks were started; whether this is the first or only one; and its name for messages, "rank 1 of 4
/// on node7: ", empty for a process alone. They read the environment, and work before there are Ranks.
bool are_several_ranks();
bool is_first_rank();
std::string rank_text();

/// Lets the first rank tell an error that several ranks meet: other ranks wait for a second, in which the first one
/// ends them.
void let_first_rank_speak();
/// Ends all ranks at once, with this exit code; does nothing where MPI does not run.
void end_all_ranks(int exit_code);

/// The cores that a rank takes so that all ranks of a node have equally many, and share none if there are enough.
/// cores: for each rank the cores on which it may run, ascending.
std::vector<int> share_of_cores(const std::vector<std::vector<int>>& cores, std::size_t rank);

/// Hands out the numbers 0..n-1, each once, to n_ranks ranks that work at different speeds. Neighbours often share
/// something that is made once in each process: therefore each rank has a stretch of its own, all of equal length, and
/// a rank that has finished its stretch takes numbers from the far end of the longest stretch that is left.
class Shares {
 public:
  Shares(std::size_t n, std::size_t n_ranks);

  /// The next number for a rank; empty: none is left. from_front: of its own stretch, for threads that work from both
  /// ends towards the middle.
  std::optional<std::size_t> next(std::size_t rank, bool from_front);

 private:
  struct Stretch {
    std::size_t front, back;
    [[nodiscard]] std::size_t size() const { return back - front; }
  };
  std::vector<Stretch> stretches_;
};

}  // namespace fretval
