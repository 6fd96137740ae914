#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/command_line/verbs.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/made_up_operator.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::store_command_test {
namespace {

namespace fs = std::filesystem;

class StoreCommand : public testing::Test {
 protected:
  /// Of a case, in its folder of results.
  nlohmann::json result_of_run(const std::string& options) const {
    const auto file = scratch_.write("case.prm", elastic_case());
    const auto out = scratch_.path() / "out";
    const auto run = fretval_run("-v run " + quoted(file) + " -o " + quoted(out) + " " + options, scratch_);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    log_ = run.err;
    return nlohmann::json::parse(text_of(out / "case/result.json"));
  }
  fretval::Run store(const std::string& arguments) const {
    return fretval_run("store " + arguments + " --store " + quoted(folder_), scratch_);
  }
  [[nodiscard]] std::string own() const { return "--store " + quoted(folder_); }

  ScratchFolder scratch_;
  fs::path folder_ = scratch_.path() / "operators";
  mutable std::string log_;
};

nlohmann::json without_cost(nlohmann::json result) {
  result.erase("cost");
  return result;
}

// Bit for bit: JSON has 17 digits of each number.
TEST_F(StoreCommand, AResultFromTheStoreIsTheOneWithoutIt) {
  const auto without = result_of_run("--no-store");
  EXPECT_FALSE(fs::exists(folder_));
  const auto first = result_of_run(own());
  EXPECT_EQ(first.at("cost").at("bodies_from_store"), 0);
  expect_parts(log_, {"bodies made, 0 from the store"});
  const auto second = result_of_run(own());
  expect_parts(log_, {"0 bodies made, ", "from the store " + folder_.string()});
  const auto &bodies = second.at("cost").at("bodies"), &seconds = second.at("cost").at("seconds");
  EXPECT_GT(bodies, 1);
  EXPECT_EQ(second.at("cost").at("bodies_from_store"), bodies);
  EXPECT_EQ(seconds.at("factorisation"), 0);
  EXPECT_GT(seconds.at("reading"), 0);
  EXPECT_EQ(without_cost(first), without_cost(without));
  EXPECT_EQ(without_cost(second), without_cost(without));
}

TEST_F(StoreCommand, WhatIsDamagedIsMadeAgain) {
  const auto first = result_of_run(own() + " --proof none");
  for (const auto& entry : entries_of(folder_)) fs::resize_file(entry.file, 1000);
  EXPECT_EQ(store("verify").exit_code, 1);
  const auto second = result_of_run(own() + " --proof none");
  expect_parts(log_, {"its checksum is not that of its content; it is made again"});
  EXPECT_EQ(second.at("cost").at("bodies_from_store"), 0);
  EXPECT_EQ(without_cost(first), without_cost(second));
  EXPECT_EQ(store("verify").exit_code, 0);
}

TEST_F(StoreCommand, ListsVerifiesAndClears) {
  result_of_run(own() + " --proof none");
  OperatorStore(folder_).keep(made_up_operator("made by\nan older program\nharmonic 0\n"));
  const auto list = store("");
  EXPECT_EQ(list.exit_code, 0);
  expect_parts(list.out, {"normal harmonic, 28 rings", "tangential harmonic, 28 rings", "8 rings, 7 dofs",
                          "of another version", "3 operators", "of 2.0 GiB"});
  const auto file = entries_of(folder_).at(0).file;
  std::ofstream(file) << "no operator";
  EXPECT_EQ(store("list").exit_code, 0);
  const auto verify = store("verify");
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(verify.out, {file.filename().string(), "DAMAGED: it is no file of an operator"});
  EXPECT_EQ(verify.out.find("28 rings"), std::string::npos);
  expect_parts(store("clear").out, {"3 files removed"});
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(StoreCommand, SaysWhichStoreThereIs) {
  const auto nowhere =
      shell_run("unset FRETVAL_STORE XDG_CACHE_HOME HOME; " + std::string(FRETVAL_PROGRAM) + " store", scratch_);
  EXPECT_EQ(nowhere.exit_code, 2);
  expect_parts(nowhere.err, {"--store", "FRETVAL_STORE", "XDG_CACHE_HOME"});
  const auto cache = shell_run("unset FRETVAL_STORE; XDG_CACHE_HOME=" + quoted(scratch_.path()) +
                                   " FRETVAL_STORE_LIMIT=3MiB " + FRETVAL_PROGRAM + " store",
                               scratch_);
  expect_parts(cache.out, {(scratch_.path() / "fretval").string() + ": 0 operators", "of 3.0 MiB"});
  EXPECT_EQ(store("list --store-limit much").exit_code, 2);
  EXPECT_EQ(store("burn").exit_code, 2);
}

TEST_F(StoreCommand, AFileInPlaceOfTheFolderIsNoStore) {
  std::ofstream(folder_) << "a file";
  result_of_run(own() + " --proof none");
  expect_parts(log_, {"the store of operators is not written to", "--no-store"});
  EXPECT_EQ(store("list").exit_code, 4);
}

TEST_F(StoreCommand, AddsUpTheSizesOfAllOperators) {
  for (const int n : {8, 16, 40}) OperatorStore(folder_).keep(made_up_operator(fmt::format("of {}\nrings\n", n), n));
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder_))
    if (entry.path().extension() == entries_of(folder_).front().file.extension()) bytes += fs::file_size(entry.path());
  expect_parts(store("").out, {fmt::format("3 operators, {:.1f} KiB of", static_cast<double>(bytes) / 1024)});
}

}  // namespace
}  // namespace fretval::store_command_test
