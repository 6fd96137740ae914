#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparison/report/text/filling.h"

namespace fretval {

/// A cell of a table.
struct Cell {
  std::string text;
  bool is_bad = false;       ///< in red
  bool is_words = false;     ///< a sentence rather than a number or a name
  bool is_head = false;      ///< a heading of the rows below it
  std::string details = {};  ///< what a page shows on request

  Cell(std::string words) : text(std::move(words)) {}
  Cell(const char* words) : text(words) {}
};

Cell words_cell(const std::string& text);
Cell head_cell(const std::string& text);
Cell bad_if(bool is_bad, const std::string& text);

/// A table that a page and a terminal show in the same way.
struct Table {
  std::vector<std::string> heads;
  std::vector<std::vector<Cell>> rows = {};  ///< the only cell of a row goes over all columns
  std::string label = {};                    ///< what a screen reader says of it; empty: the first head
};

/// The table as a filling of the template `table`.
Filling filling_of(const Table& table);

/// The table as text in aligned columns, with the first one and sentences aligned to the left.
std::string text_of(const Table& table);

/// All tables within a filling, each below its label, if it has one of its own.
std::string tables_text(const Filling& part);

}  // namespace fretval
