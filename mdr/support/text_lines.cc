#include "mdr/support/text_lines.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace fretval::mdr {

namespace {

constexpr std::size_t max_lines = 1'100'000;
constexpr std::size_t max_line_length = 10'000;

using Byte = unsigned char;

void append_utf8(unsigned code, std::string& text) {
  const auto add = [&text](unsigned byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | (code >> 6));
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | (code >> 12));
    add(0x80 | ((code >> 6) & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | (code >> 18));
    add(0x80 | ((code >> 12) & 0x3F));
    add(0x80 | ((code >> 6) & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

/// The text of the bytes after the mark; half a character at the end is left out.
std::string from_utf16(std::string_view bytes, bool big_endian) {
  std::string text;
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<Byte>(bytes[i]), second = static_cast<Byte>(bytes[i + 1]);
    return big_endian ? first * 256U + second : second * 256U + first;
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    unsigned code = unit(i);
    const bool leads = code >= 0xD800 && code < 0xDC00;
    if (leads && i + 3 < bytes.size()) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    append_utf8(code, text);
  }
  return text;
}

/// How many bytes follow the first one of a character; -1: it begins none.
int n_following(Byte first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int n = n_following(static_cast<Byte>(text[i])); n != 0; --n) {
      if (n < 0 || ++i == text.size() || (static_cast<Byte>(text[i]) & 0xC0) != 0x80) return false;
    }
  }
  return true;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto code = static_cast<Byte>(c);
    // Windows 1252 differs from Latin-1 in some characters, of which apostrophes alone are found in names of columns.
    append_utf8(code == 0x91 || code == 0x92 || code == 0xB4 ? '\'' : code, text);
  }
  return text;
}

std::string all_of(std::istream& stream, const std::string& source_name) {
  if (!stream) throw std::invalid_argument(source_name + ": cannot be read; must be a readable text file");
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw std::invalid_argument(source_name + ": could not be read to its end");
  const std::string_view mark = std::string_view(bytes).substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF") return from_utf16(std::string_view(bytes).substr(2), mark[0] == '\xFE');
  if (bytes.rfind("\xEF\xBB\xBF", 0) == 0) bytes.erase(0, 3);
  return bytes;
}

}  // namespace

void fail_at(const std::string& source_name, const TextLine& line, const std::string& problem) {
  std::string shown = line.text.substr(0, 60);
  for (char& c : shown) {
    if (static_cast<Byte>(c) < ' ') c = c == '\t' ? ' ' : '?';
  }
  throw std::invalid_argument(source_name + ", line " + std::to_string(line.number) + ", \"" + shown +
                              "\": " + problem);
}

std::vector<TextLine> read_lines(std::istream& stream, const std::string& source_name) {
  const std::string text = all_of(stream, source_name);
  std::vector<TextLine> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    TextLine line{static_cast<int>(lines.size()) + 1, text.substr(begin, std::min(end - begin, max_line_length + 1))};
    if (line.text.find('\0') != std::string::npos) fail_at(source_name, line, "holds a zero byte; must be a text file");
    if (line.text.size() > max_line_length)
      fail_at(source_name, line, "must have at most " + std::to_string(max_line_length) + " characters");
    if (lines.size() == max_lines) fail_at(source_name, line, "is one line too many");
    if (!is_utf8(line.text)) line.text = from_latin1(line.text);
    lines.push_back(std::move(line));
    begin = end + 1;
    if (end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n') ++begin;
  }
  return lines;
}

}  // namespace fretval::mdr
