#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace fretval {

/// A cell of a table.
struct Cell {
  std::string text;
  bool is_bad = false;       ///< in red
  bool is_words = false;     ///< a sentence rather than a number or a name
  std::string details = {};  ///< what a page shows on request

  Cell(std::string words) : text(std::move(words)) {}
  Cell(const char* words) : text(words) {}
};

Cell words_cell(const std::string& text);
Cell bad_if(bool is_bad, const std::string& text);

/// What a page and a terminal show alike.
struct Table {
  std::vector<std::string> heads;  ///< HTML
  std::vector<std::vector<Cell>> rows = {};
};

/// As HTML, whose cells are escaped.
std::string html_of(const Table& table);

/// In aligned columns, the first one and sentences to the left.
std::string text_of(const Table& table);

/// A dash for what is no finite number.
std::string number_text(const nlohmann::ordered_json& value, const char* format = "{:.1e}");

}  // namespace fretval
