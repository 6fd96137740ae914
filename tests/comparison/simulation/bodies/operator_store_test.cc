#include "comparison/simulation/bodies/operator_store.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "tests/comparison/made_up_operator.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::operator_store_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class OperatorStoreTest : public testing::Test {
 protected:
  void keep(const std::string& key) { store_.keep(made_up_operator(key)); }
  fs::path file_of(const std::string& key) const { return store_.file_of(key); }
  void used_ago(const std::string& key, std::chrono::minutes time) const {
    fs::last_write_time(file_of(key), fs::file_time_type::clock::now() - time);
  }
  /// What tests do to a file; afterwards the store must neither have it nor mind.
  template <class Spoil>
  void expect_not_trusted(const Spoil& spoil) {
    keep("a");
    ASSERT_TRUE(store_.find("a"));
    spoil(file_of("a"));
    EXPECT_FALSE(store_.find("a"));
    keep("a");
    EXPECT_TRUE(store_.find("a"));
  }

  ScratchFolder scratch_;
  fs::path folder_ = scratch_.path() / "made" / "when needed";
  OperatorStore store_{folder_};
};

TEST_F(OperatorStoreTest, FindsWhatWasKeptAndNothingElse) {
  EXPECT_FALSE(store_.find("a"));
  EXPECT_FALSE(fs::exists(folder_)) << "a search makes no folder";
  keep("a");
  const auto found = store_.find("a");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found->compliance.matrix, *made_up_operator("a").compliance.matrix);
  EXPECT_FALSE(store_.find("b"));
  EXPECT_TRUE(OperatorStore(folder_).find("a")) << "in another process";
}

TEST_F(OperatorStoreTest, ATruncatedFileIsNotTrusted) {
  expect_not_trusted([](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); });
  expect_not_trusted([](const fs::path& file) { fs::resize_file(file, 0); });
}

TEST_F(OperatorStoreTest, AFlippedByteIsNotTrusted) {
  expect_not_trusted([](const fs::path& file) {
    auto bytes = text_of(file);
    bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
    std::ofstream(file, std::ios::binary) << bytes;
  });
}

TEST_F(OperatorStoreTest, AForeignFileOfTheRightNameIsNotTrusted) {
  expect_not_trusted([](const fs::path& file) { std::ofstream(file) << "a letter to somebody"; });
  expect_not_trusted([](const fs::path& file) { fs::remove(file); });
}

// As if two keys had one hash, or somebody had renamed a file.
TEST_F(OperatorStoreTest, AnOperatorOfAnotherKeyIsNotTrusted) {
  keep("b");
  expect_not_trusted(
      [&](const fs::path& file) { fs::copy_file(file_of("b"), file, fs::copy_options::overwrite_existing); });
}

TEST_F(OperatorStoreTest, AFolderOfTheRightNameStopsNothing) {
  fs::create_directories(file_of("a"));
  EXPECT_FALSE(store_.find("a"));
  keep("a");
  EXPECT_FALSE(store_.find("a"));
  EXPECT_TRUE(entries_of(folder_).empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "nothing is left beside it";
}

// /proc takes no folders and no files, whoever asks.
TEST(OperatorStore, AFolderThatCannotBeWrittenStopsNothingAndIsWarnedOfOnce) {
  OperatorStore store("/proc/fretval");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  store.keep(made_up_operator("a"));
  store.keep(made_up_operator("b"));
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_FALSE(store.find("a"));
  const auto first = said.find("not written to");
  EXPECT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find("not written to", first + 1), std::string::npos) << said;
}

// A full disk: no file may grow.
TEST_F(OperatorStoreTest, AFullDiskLeavesNoHalfOfAFile) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit small{4096, 4096};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    store_.keep(made_up_operator("a", 64));
    _exit(store_.find("a") ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OperatorStoreTest, ProcessesAtOnceKeepWholeFiles) {
  constexpr int n_processes = 4, n_rounds = 30;
  std::vector<pid_t> children;
  for (int i = 0; i < n_processes; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      bool good = true;
      for (int round = 0; round < n_rounds; ++round) {
        OperatorStore own(folder_);
        own.keep(made_up_operator("shared"));
        const auto found = own.find("shared");
        good = good && found && *found->compliance.matrix == *made_up_operator("shared").compliance.matrix;
      }
      _exit(good ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "one file, and nothing beside it";
}

TEST_F(OperatorStoreTest, WhatWasUsedLongestAgoGoesAboveTheLimit) {
  const auto size = fem::operator_file(made_up_operator("a")).size();
  OperatorStore store(folder_, 10 * size + size / 2);
  for (int i = 0; i < 10; ++i) {
    const auto key = std::to_string(i);
    store.keep(made_up_operator(key));
    used_ago(key, std::chrono::minutes(100 - i));
  }
  ASSERT_TRUE(store.find("0")) << "used just now";
  store.keep(made_up_operator("new"));
  EXPECT_EQ(entries_of(folder_).size(), 9U) << "nine tenths of the limit";
  for (const char* gone : {"1", "2"}) EXPECT_FALSE(store.find(gone)) << gone;
  for (const char* kept : {"0", "3", "9", "new"}) EXPECT_TRUE(store.find(kept)) << kept;
}

TEST_F(OperatorStoreTest, AnOperatorAboveTheLimitIsNotKept) {
  keep("a");
  OperatorStore(folder_, 100).keep(made_up_operator("b"));
  EXPECT_EQ(entries_of(folder_).size(), 1U);
}

TEST_F(OperatorStoreTest, ListsAndClearsItsOwnFilesAlone) {
  EXPECT_TRUE(entries_of(folder_).empty());
  EXPECT_EQ(clear_store(folder_), 0U);
  keep("a");
  keep("b");
  used_ago("b", 5min);
  const fs::path thesis = folder_ / "thesis.h5", left = file_of("c").string() + ".4711.partial";
  std::ofstream(thesis) << "years of work";
  std::ofstream(left) << "half";
  const auto entries = entries_of(folder_);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].file, file_of("a"));
  EXPECT_EQ(entries[1].bytes, fem::operator_file(made_up_operator("b")).size());
  EXPECT_EQ(clear_store(folder_), 3U);
  EXPECT_TRUE(fs::exists(thesis));
  EXPECT_FALSE(fs::exists(left));
}

// Another process evicts meanwhile.
TEST_F(OperatorStoreTest, AnEntryMayGoBetweenTheListAndItsReading) {
  keep("a");
  const auto entries = entries_of(folder_);
  fs::remove(entries.at(0).file);
  EXPECT_THROW(bytes_of(entries.at(0).file), fem::OperatorFileError);
}

// With the next eviction, once it is old.
TEST_F(OperatorStoreTest, RemovesWhatKilledProcessesHaveLeft) {
  keep("a");
  const auto old = file_of("c").string() + ".1.partial", young = file_of("c").string() + ".2";
  for (const auto& file : {old, young}) std::ofstream(file) << "half";
  fs::last_write_time(old, fs::file_time_type::clock::now() - 2h);
  const auto size = fem::operator_file(made_up_operator("b")).size();
  OperatorStore(folder_, size + size / 2).keep(made_up_operator("b"));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young)) << "somebody may be writing it";
}

}  // namespace
}  // namespace fretval::operator_store_test
