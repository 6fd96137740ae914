#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace fretval::meshes {

/// The text of a file, taken word by word. Every error names the file and the line.
class Words {
 public:
  /// Throws MeshError if the file is missing, cannot be read or is empty.
  explicit Words(const std::filesystem::path& file);

  bool at_end();

  /// The next word. `what` names it in the error if the file ends before it, as in all functions below.
  std::string_view next(std::string_view what);
  void expect(std::string_view word);
  std::string quoted(std::string_view what);
  double real(std::string_view what);
  long long integer(std::string_view what);
  /// How many items follow: no fewer than 0, and no more than the rest of the file has characters.
  std::size_t count(std::string_view what);

  /// Throws MeshError "FILE, line N: what is value, must be valid".
  [[noreturn]] void fail(std::string_view what, std::string_view value, std::string_view valid) const;

 private:
  void skip_blanks();

  std::string file;
  std::string text;
  std::size_t position = 0;
};

}  // namespace fretval::meshes
