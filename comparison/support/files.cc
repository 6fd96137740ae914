#include "comparison/support/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace fretval {

namespace fs = std::filesystem;

void write_file(const fs::path& file, const std::string& content) {
  fs::path partial = file;
  partial += ".partial";
  errno = 0;
  std::ofstream stream(partial, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) {
    const std::error_code code(errno ? errno : EIO, std::generic_category());
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw fs::filesystem_error("cannot write", file, code);
  }
  fs::rename(partial, file);
}

std::string content_of(const fs::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

void write_csv(const fs::path& file, const std::vector<Column>& columns, int n_digits) {
  fmt::memory_buffer text;
  for (std::size_t k = 0; k < columns.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{}{}", columns[k].name, k + 1 < columns.size() ? ',' : '\n');
  for (Eigen::Index i = 0; i < columns.front().values.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      fmt::format_to(std::back_inserter(text), "{:.{}g}{}", columns[k].values[i], n_digits,
                     k + 1 < columns.size() ? ',' : '\n');
  write_file(file, fmt::to_string(text));
}

}  // namespace fretval
