#include "comparison/support/ranks.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_ranks.h"
#include "tests/comparison/variable.h"

namespace fretval::ranks_test {
namespace {

using Cores = std::vector<std::vector<int>>;

TEST(Ranks, AProcessAloneIsTheFirstAndOnlyOne) {
  const Ranks ranks;
  EXPECT_TRUE(ranks.is_first());
  EXPECT_FALSE(ranks.are_several());
  EXPECT_EQ(ranks.sum({1, 2}), (std::vector<long>{1, 2}));
  EXPECT_EQ(rank_text(), "");
}

TEST(Ranks, AreNamedInMessages) {
  const Variable number("OMPI_COMM_WORLD_RANK", "1"), count("OMPI_COMM_WORLD_SIZE", "4");
  EXPECT_EQ(rank_text().find("rank 1 of 4 on "), 0U);
  EXPECT_TRUE(are_several_ranks());
  EXPECT_FALSE(is_first_rank());
}

TEST(Ranks, ShareOutTheCoresThatAllMayUse) {
  const Cores unbound(3, {0, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(share_of_cores(unbound, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(share_of_cores(unbound, 1), (std::vector<int>{3, 4}));
  EXPECT_EQ(share_of_cores(unbound, 2), (std::vector<int>{5, 6}));
}

TEST(Ranks, KeepTheCoresThatTheyWereBoundTo) {
  const Cores bound{{0, 1}, {4, 5}};
  for (const std::size_t rank : {0, 1}) EXPECT_EQ(share_of_cores(bound, rank), bound[rank]);
}

TEST(Ranks, HaveOneCoreAtLeast) {
  const Cores too_many(4, {2, 3});
  for (const std::size_t rank : {0, 1, 2, 3}) EXPECT_EQ(share_of_cores(too_many, rank).size(), 1U);
}

// Those that cannot share their work are not started by halves.
TEST(RanksOfAProgram, AreForRunsAlone) {
  const ScratchFolder folder;
  folder.write("case.prm", valid_case);
  const auto run = ranked_run(2, "mdr case.prm", folder);
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_EQ(run.out, "");
  expect_parts(run.err, {"mdr: works in one process; mpirun is for fretval run alone"});
}

TEST(RanksOfAProgram, RefuseABadCase) {
  const ScratchFolder folder;
  folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto run = ranked_run(2, "run bad.prm -o out", folder);
  EXPECT_EQ(run.exit_code, 2) << run.err;
  expect_parts(run.err, {"bad.prm: Elastomer / Relaxed shear modulus = -1"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

/// Long enough to be interrupted.
const std::string sweep =
    valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:0.36:180\nend\n";

TEST(RanksOfAProgramSlow, EndTogetherWhereOneIsKilled) {
  for (const auto& [signal, exit_code] : {std::pair("KILL", 137), std::pair("ABRT", 134)})
    for (const int victim : {0, 1}) {
      const ScratchFolder folder;
      folder.write("sweep.prm", sweep);
      const auto run =
          ranked_run(2, "run sweep.prm -o out", folder,
                     fmt::format("[ $OMPI_COMM_WORLD_RANK != {} ] || (sleep 3; kill -{} $$) &", victim, signal));
      EXPECT_EQ(run.exit_code, exit_code) << run.err;
      expect_parts(run.err, {fmt::format("rank {}", victim), "exited on signal"});
      EXPECT_TRUE(std::filesystem::exists(folder.path() / "out"));
    }
}

// A disk that is full for one of them.
TEST(RanksOfAProgramSlow, EndTogetherWhereOneFails) {
  const ScratchFolder folder;
  folder.write("sweep.prm", sweep);
  const auto run = ranked_run(2, "run sweep.prm --no-store -o out", folder,
                              "[ $OMPI_COMM_WORLD_RANK = 0 ] || { trap \"\" XFSZ; ulimit -f 1; };");
  EXPECT_EQ(run.exit_code, 4) << run.err;
  expect_parts(run.err, {"error: rank 1 of 2 on "});
}

TEST(Shares, HandOutEachNumberOnce) {
  for (const std::size_t n : {0, 1, 2, 7, 100})
    for (const std::size_t n_ranks : {1, 2, 3, 8}) {
      Shares shares(n, n_ranks);
      std::set<std::size_t> given;
      for (std::size_t asked = 0; asked < n; ++asked)
        EXPECT_TRUE(given.insert(shares.next(asked * asked % n_ranks, asked % 3 == 0).value()).second);
      EXPECT_EQ(given.size(), n);
      for (std::size_t rank = 0; rank < n_ranks; ++rank) EXPECT_FALSE(shares.next(rank, true));
    }
}

TEST(Shares, AreStretchesThatTwoThreadsTakeFromBothEnds) {
  Shares shares(10, 2);
  EXPECT_EQ(shares.next(0, true), 0U);
  EXPECT_EQ(shares.next(0, false), 4U);
  EXPECT_EQ(shares.next(1, true), 5U);
  EXPECT_EQ(shares.next(1, true), 6U);
  EXPECT_EQ(shares.next(0, true), 1U);
}

// One rank alone does it all: where the others have most left, and from the end that they come to last.
TEST(Shares, GoToWhoIsDoneWithHisOwn) {
  Shares shares(9, 3);
  EXPECT_EQ(shares.next(1, true), 3U);
  for (const std::size_t expected : {0, 1, 2, 8}) EXPECT_EQ(shares.next(0, true), expected);
  Shares two(6, 2);
  for (const std::size_t expected : {0, 1, 2, 5, 4}) EXPECT_EQ(two.next(0, true), expected);
  EXPECT_EQ(two.next(1, true), 3U);
}

}  // namespace
}  // namespace fretval::ranks_test
