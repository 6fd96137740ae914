#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>

#include "comparison/case/case.h"
#include "comparison/command_line/ending.h"
#include "comparison/command_line/verbs.h"
#include "comparison/simulation/bodies/operator_key.h"
#include "comparison/support/folders.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::string size_text(std::uintmax_t bytes) {
  constexpr double kilo = 1024;
  const auto size = static_cast<double>(bytes);
  if (size < kilo * kilo) return fmt::format("{:.1f} KiB", size / kilo);
  if (size < kilo * kilo * kilo) return fmt::format("{:.1f} MiB", size / (kilo * kilo));
  return fmt::format("{:.1f} GiB", size / (kilo * kilo * kilo));
}

std::string time_text(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return "gone";
  return fmt::format("{:%F %T}", fmt::localtime(status.st_mtime));
}

std::string operator_text(const fem::StoredOperator& stored) {
  const auto& figures = stored.figures;
  const auto figure = [&](const char* name) { return figures.count(name) > 0 ? figures.at(name) : 0; };
  return fmt::format(
      "{} harmonic, {} rings, {:.0f} dofs{}", is_of_harmonic(stored.key, fem::axisymmetric) ? "normal" : "tangential",
      stored.compliance.areas.size(), figure("dofs"), is_of_this_version(stored.key) ? "" : ", of another version");
}

void print_total(const std::vector<StoreEntry>& entries, const OperatorStore& store) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : entries) bytes += entry.bytes;
  fmt::print("{}: {} operators, {} of {}\n", store.folder().string(), entries.size(), size_text(bytes),
             size_text(store.limit()));
}

/// What is in an entry; or, damaged, why it cannot be used.
struct EntryText {
  std::string text;
  bool damaged = false;
};

EntryText text_of(const StoreEntry& entry) {
  try {
    return {operator_text(fem::operator_in(bytes_of(entry.file)))};
  } catch (const fem::OperatorFileError& error) {
    return {std::string("DAMAGED: ") + error.what(), true};
  }
}

/// Prints all entries, or the damaged ones alone; returns whether there is one.
bool print_entries_of(const OperatorStore& store, bool damaged_alone) {
  const auto entries = entries_of(store.folder());
  bool any_damaged = false;
  for (const auto& entry : entries) {
    const auto [text, damaged] = text_of(entry);
    any_damaged |= damaged;
    if (damaged || !damaged_alone)
      fmt::print("{}  {:>10}  {}  {}\n", entry.file.filename().string(), size_text(entry.bytes), time_text(entry.file),
                 text);
  }
  print_total(entries, store);
  return any_damaged;
}

}  // namespace

void add_store_options(CLI::App& verb, StoreOptions& options) {
  options.folder = cache_folder().value_or("").string();
  verb.add_option("--store", options.folder, "Folder of the store of operators")->envname("FRETVAL_STORE");
  verb.add_option("--store-limit", options.limit, "Size of the store above which the longest unused goes, as 500MiB")
      ->envname("FRETVAL_STORE_LIMIT")
      ->transform(CLI::AsSizeValue(false))
      ->default_str("2GiB");
}

std::shared_ptr<OperatorStore> store_of(const StoreOptions& options) {
  if (options.none || options.folder.empty()) return nullptr;
  return std::make_shared<OperatorStore>(options.folder, options.limit);
}

int run_store(const std::string& action, const StoreOptions& options) {
  const auto store = store_of(options);
  if (!store) throw InputError("--store: neither it nor FRETVAL_STORE, XDG_CACHE_HOME or HOME names a folder");
  if (action == "clear") {
    fmt::print("{}: {} files removed\n", store->folder().string(), clear_store(store->folder()));
    return exit_agree;
  }
  const bool verifies = action == "verify";
  const bool any_damaged = print_entries_of(*store, verifies);
  return verifies && any_damaged ? exit_disagree : exit_agree;
}

}  // namespace fretval
