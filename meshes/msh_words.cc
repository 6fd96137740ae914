#include "meshes/msh_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>

#include "meshes/mesh_error.h"

namespace fretval::meshes {
namespace {

template <typename Number>
bool parse(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

Words::Words(const std::filesystem::path& path) : file(path.string()) {
  if (!std::filesystem::exists(path)) throw MeshError(fmt::format("{}: no such file, must be a .msh file", file));
  std::ifstream stream(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !stream)
    throw MeshError(fmt::format("{}: cannot be opened, must be a readable .msh file", file));
  text.assign(std::istreambuf_iterator<char>(stream), {});
  if (at_end())
    throw MeshError(fmt::format("{}: has {} characters, none but blanks, must be a .msh file", file, text.size()));
}

void Words::skip_blanks() {
  while (position < text.size() && std::isspace(static_cast<unsigned char>(text[position]))) ++position;
}

bool Words::at_end() {
  skip_blanks();
  return position == text.size();
}

std::string_view Words::next(std::string_view what) {
  if (at_end()) fail(what, "missing", "there: the file ends too early");
  const std::size_t first = position;
  while (position < text.size() && !std::isspace(static_cast<unsigned char>(text[position]))) ++position;
  return std::string_view(text).substr(first, position - first);
}

void Words::expect(std::string_view word) {
  const auto found = next(word);
  if (found != word) fail("the next word", found, word);
}

std::string Words::quoted(std::string_view what) {
  if (at_end() || text[position] != '"') fail(what, next(what), "in double quotes");
  const std::size_t end = text.find('"', position + 1);
  if (end == std::string::npos) fail(what, "without end", "in double quotes");
  std::string inside = text.substr(position + 1, end - position - 1);
  position = end + 1;
  return inside;
}

double Words::real(std::string_view what) {
  const auto word = next(what);
  double number = 0.;
  if (!parse(word, number)) fail(what, word, "a number");
  return number;
}

long long Words::integer(std::string_view what) {
  const auto word = next(what);
  long long number = 0;
  if (!parse(word, number)) fail(what, word, "a whole number");
  return number;
}

std::size_t Words::count(std::string_view what) {
  const long long number = integer(what);
  const auto rest = static_cast<long long>(text.size() - position);
  if (number < 0 || number > rest)
    fail(what, fmt::format("{}", number), fmt::format("between 0 and what the rest of the file can hold, {}", rest));
  return static_cast<std::size_t>(number);
}

void Words::fail(std::string_view what, std::string_view value, std::string_view valid) const {
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n');
  throw MeshError(fmt::format("{}, line {}: {} is {}, must be {}", file, line, what, value, valid));
}

}  // namespace fretval::meshes
