#include "comparison/report/text/table.h"

#include <algorithm>

namespace fretval {
namespace {

Filling filling_of_cell(const Cell& cell) {
  Filling filling{{"text", cell.text}};
  if (cell.is_bad || cell.is_words || cell.is_head)
    filling["class"] = cell.is_bad ? "bad-cell" : cell.is_words ? "words" : "head";
  if (!cell.details.empty()) filling["details"] = cell.details;
  return filling;
}

/// The table from a filling that filling_of() has made of it.
Table table_of(const Filling& filling) {
  Table table{filling.at("heads").get<std::vector<std::string>>()};
  for (const auto& row : filling.at("rows")) {
    table.rows.emplace_back();
    for (const auto& filled : row.at("cells")) {
      table.rows.back().emplace_back(filled.at("text").get<std::string>());
      table.rows.back().back().is_words = filled.value("class", "") == "words";
    }
  }
  return table;
}

/// Whether the only cell of a row goes over all columns.
bool spans(const std::vector<Cell>& row, std::size_t n_columns) {
  return row.size() == 1 && n_columns > 1;
}

/// Characters rather than bytes of UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

Cell words_cell(const std::string& text) {
  Cell cell(text);
  cell.is_words = true;
  return cell;
}

Cell head_cell(const std::string& text) {
  Cell cell(text);
  cell.is_head = true;
  return cell;
}

Cell bad_if(bool is_bad, const std::string& text) {
  Cell cell(text);
  cell.is_bad = is_bad;
  return cell;
}

Filling filling_of(const Table& table) {
  Filling filling{{"template", "table"},
                  {"label", table.label.empty() ? table.heads.front() : table.label},
                  {"heads", table.heads},
                  {"rows", Filling::array()}};
  for (const auto& row : table.rows) {
    auto cells = Filling::array();
    for (const auto& cell : row) cells.push_back(filling_of_cell(cell));
    if (spans(row, table.heads.size())) cells.front()["span"] = table.heads.size();
    filling["rows"].push_back({{"cells", std::move(cells)}});
  }
  return filling;
}

std::string text_of(const Table& table) {
  auto rows = table.rows;
  rows.insert(rows.begin(), {table.heads.begin(), table.heads.end()});
  std::vector<std::size_t> widths(table.heads.size(), 0);
  std::vector<bool> to_the_left(table.heads.size(), false);
  to_the_left.front() = true;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!spans(row, widths.size())) widths[k] = std::max(widths[k], width_of(row[k].text));
      if (row[k].is_words) to_the_left[k] = true;
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string blanks(std::max(widths[k], width_of(row[k].text)) - width_of(row[k].text), ' ');
      line += (k == 0 ? "" : "  ") + (to_the_left[k] ? row[k].text + blanks : blanks + row[k].text);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string tables_text(const Filling& part) {
  std::string text;
  if (part.is_object() && part.value("template", "") == "table") {
    const auto table = table_of(part);
    const auto& label = part.at("label");
    return (label == table.heads.front() ? "" : label.get<std::string>() + "\n") + text_of(table) + "\n";
  }
  if (part.is_structured())
    for (const auto& one : part) text += tables_text(one);
  return text;
}

}  // namespace fretval
