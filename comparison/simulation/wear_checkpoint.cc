#include "comparison/simulation/wear_checkpoint.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "comparison/support/files.h"
#include "comparison/support/log.h"
#include "fem/condensation/operator_file.h"
#include "fem/wear/wear_archive.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::string checksum(const std::string& bytes) {
  return fmt::format("{:016x}", fem::checksum(bytes.data(), bytes.size()));
}

}  // namespace

WearCheckpoint::WearCheckpoint(const fs::path& folder, std::string what) : what_(std::move(what)) {
  if (!folder.empty()) file_ = folder / (checksum(what_) + ".wear");
}

std::optional<fem::WearState> WearCheckpoint::restored(fem::WearState state) const {
  if (file_.empty() || !fs::exists(file_)) return std::nullopt;
  const std::string all = content_of(file_), sum = checksum({}),
                    content = all.size() > sum.size() ? all.substr(sum.size()) : std::string();
  const bool whole = all.compare(0, sum.size(), checksum(content)) == 0;
  if (!whole || content.compare(0, what_.size(), what_) != 0) {
    log::warn(fmt::format("{}: {}; the wear begins anew", file_.string(), whole ? "is of another wear" : "is damaged"));
    return std::nullopt;
  }
  fem::restore(content.substr(what_.size()), state);
  return state;
}

void WearCheckpoint::keep(const fem::WearState& state) {
  if (file_.empty()) return;
  const auto content = what_ + fem::archived(state);
  try {
    fs::create_directories(file_.parent_path());
    write_file(file_, checksum(content) + content);
  } catch (const fs::filesystem_error& error) {
    log::warn(fmt::format("{}; the wear goes on without checkpoints", error.what()));
    file_.clear();
  }
}

}  // namespace fretval
