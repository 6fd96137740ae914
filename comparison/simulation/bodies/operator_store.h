#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fem/condensation/operator_file.h"

namespace fretval {

/// A file of a store.
struct StoreEntry {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type last_use = {};
};

/// Condensed operators in a folder, a file for each, shared by all processes and runs: what is found is what was kept,
/// bit for bit, and what is damaged, foreign or of another version is as good as not there.
///
/// Files are named after a hash of their key, which they contain and which is compared. They are written beside their
/// place and renamed, so readers need no lock and processes that keep the same operator at once replace each other's
/// equal files. A read renews the time of the file; above the limit, what was used longest ago goes, down to nine
/// tenths of it. Nothing that happens to the folder stops a run: what cannot be written is a warning, once, and nothing
/// is written after it. All of it may be called by several threads.
class OperatorStore {
 public:
  static constexpr std::uintmax_t usual_limit = std::uintmax_t{2} << 30;

  /// The folder is made when something is kept.
  explicit OperatorStore(std::filesystem::path folder, std::uintmax_t limit = usual_limit)
      : folder_(std::move(folder)), limit_(limit) {}

  /// The operator of a key, unless there is none that can be trusted.
  [[nodiscard]] std::optional<fem::StoredOperator> find(const std::string& key) const;

  /// Keeps an operator. Failures of the folder are not thrown.
  void keep(const fem::StoredOperator& stored);

  /// Where an operator of that key is or would be.
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::uintmax_t limit() const { return limit_; }

 private:
  void evict();

  std::filesystem::path folder_;
  std::uintmax_t limit_;
  std::mutex mutex_;                     // guards the members below
  bool is_writable_ = true;              // as far as is known
  std::optional<std::uintmax_t> bytes_;  // in the folder, as far as this process knows; empty: not counted yet
};

/// The files of a store, the last used first; what other processes remove meanwhile is left out. Files of other names
/// do not belong to it. Without a folder there are none. Throws std::filesystem::filesystem_error.
std::vector<StoreEntry> entries_of(const std::filesystem::path& folder);

/// All of a file. Throws fem::OperatorFileError if it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

/// Removes the files of a store, and unfinished ones of interrupted runs; the folder stays. Returns the number of files
/// removed. Throws std::filesystem::filesystem_error.
std::size_t clear_store(const std::filesystem::path& folder);

}  // namespace fretval
