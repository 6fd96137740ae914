#include "comparison/support/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <mutex>
#include <set>

namespace fretval::log {

void start() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("fretval"));
  // On a terminal, a message first clears the line that the progress bar may be on.
  spdlog::set_pattern(isatty(STDERR_FILENO) ? "\r\033[K%^%l%$: %v" : "%^%l%$: %v");
}

void keep_quiet() {
  spdlog::set_level(spdlog::level::warn);
}

void say_details() {
  spdlog::set_level(spdlog::level::debug);
}

bool tells() {
  return spdlog::get("fretval") != nullptr && spdlog::should_log(spdlog::level::info);
}

bool tells_details() {
  return spdlog::get("fretval") != nullptr && spdlog::should_log(spdlog::level::debug);
}

void detail(const std::string& message) {
  spdlog::debug(spdlog::string_view_t(message));
}

void info(const std::string& message) {
  spdlog::info(spdlog::string_view_t(message));
}

void warn(const std::string& message) {
  spdlog::warn(spdlog::string_view_t(message));
}

namespace {

/// Whether a message is new.
bool is_new(const std::string& message) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard<std::mutex> lock(mutex);
  return said.insert(message).second;
}

}  // namespace

void info_once(const std::string& message) {
  if (is_new(message)) info(message);
}

void warn_once(const std::string& message) {
  if (is_new(message)) warn(message);
}

void error(const std::string& message) {
  spdlog::error(spdlog::string_view_t(message));
}

}  // namespace fretval::log
