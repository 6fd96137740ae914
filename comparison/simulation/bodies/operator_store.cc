#include "comparison/simulation/bodies/operator_store.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <regex>

#include "comparison/support/files.h"
#include "comparison/support/log.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

bool is_entry(const fs::path& file) {
  static const std::regex name("[0-9a-f]{16}\\.h5");
  return std::regex_match(file.filename().string(), name);
}

/// What a killed process leaves of what it was writing.
bool is_left_over(const fs::path& file) {
  static const std::regex name("[0-9a-f]{16}\\.h5\\.[0-9]+(\\.partial)?");
  return std::regex_match(file.filename().string(), name);
}

/// No two processes write to the same file; the last one to rename its own has it.
void write_beside_others(const fs::path& file, const std::string& bytes) {
  fs::path own = file;
  own += fmt::format(".{}", getpid());
  write_file(own, bytes);
  try {
    fs::rename(own, file);
  } catch (...) {
    std::error_code ignored;
    fs::remove(own, ignored);
    throw;
  }
}

/// Regular files of a folder that may be changing.
template <class Wanted>
std::vector<StoreEntry> files_of(const fs::path& folder, const Wanted& is_wanted) {
  std::vector<StoreEntry> entries;
  std::error_code error;
  fs::directory_iterator files(folder, error);
  if (error == std::errc::no_such_file_or_directory) return entries;
  if (error) throw fs::filesystem_error("cannot read the store", folder, error);
  for (const auto& file : files) {
    if (!is_wanted(file.path()) || !file.is_regular_file(error)) continue;
    std::error_code gone;
    const StoreEntry entry{file.path(), file.file_size(error), file.last_write_time(gone)};
    if (!error && !gone) entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(),
            [](const StoreEntry& a, const StoreEntry& b) { return a.last_use > b.last_use; });
  return entries;
}

std::uintmax_t total_of(const std::vector<StoreEntry>& entries) {
  std::uintmax_t total = 0;
  for (const auto& entry : entries) total += entry.bytes;
  return total;
}

/// Files of the last hour may still be being written.
void remove_left_overs(const fs::path& folder) {
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code ignored;
  for (const auto& entry : files_of(folder, is_left_over))
    if (entry.last_use < long_ago) fs::remove(entry.file, ignored);
}

}  // namespace

fs::path OperatorStore::file_of(const std::string& key) const {
  return folder_ / fmt::format("{:016x}.h5", fem::checksum(key.data(), key.size()));
}

std::optional<fem::StoredOperator> OperatorStore::find(const std::string& key) const {
  const auto file = file_of(key);
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  try {
    auto stored = fem::operator_in(bytes_of(file), key);
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    return stored;
  } catch (const fem::OperatorFileError& error) {
    log::info(fmt::format("{}: {}; it is made again", file.string(), error.what()));
    return std::nullopt;
  }
}

void OperatorStore::keep(const fem::StoredOperator& stored) {
  const auto bytes = fem::operator_file(stored);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!is_writable_ || bytes.size() > limit_) return;
  try {
    fs::create_directories(folder_);
    write_beside_others(file_of(stored.key), bytes);
    bytes_ = bytes_ ? *bytes_ + bytes.size() : total_of(entries_of(folder_));
    if (*bytes_ > limit_) evict();
  } catch (const fs::filesystem_error& error) {
    is_writable_ = false;
    log::warn(fmt::format("the store of operators is not written to: {}; --no-store does without it", error.what()));
  }
}

void OperatorStore::evict() {
  constexpr double kept_share = 0.9;
  auto entries = entries_of(folder_);
  auto total = total_of(entries);
  const auto goal = static_cast<std::uintmax_t>(kept_share * static_cast<double>(limit_));
  for (; total > goal && !entries.empty(); entries.pop_back()) {
    std::error_code ignored;
    fs::remove(entries.back().file, ignored);
    total -= entries.back().bytes;
  }
  remove_left_overs(folder_);
  bytes_ = total;
}

std::vector<StoreEntry> entries_of(const fs::path& folder) {
  return files_of(folder, is_entry);
}

std::string bytes_of(const fs::path& file) {
  auto bytes = content_of(file);
  if (bytes.empty()) throw fem::OperatorFileError("it cannot be read");
  return bytes;
}

std::size_t clear_store(const fs::path& folder) {
  std::size_t n = 0;
  for (const auto& entry : files_of(folder, [](const fs::path& file) { return is_entry(file) || is_left_over(file); }))
    n += fs::remove(entry.file) ? 1 : 0;
  return n;
}

}  // namespace fretval
