#include "comparison/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

std::string html_of(const Cell& cell) {
  const std::string text = html_escaped(cell.text);
  const char* tag = cell.is_bad ? "<td class=\"bad-cell\">" : cell.is_words ? "<td class=\"words\">" : "<td>";
  if (cell.details.empty()) return fmt::format("{}{}</td>", tag, text);
  return fmt::format("{}<details><summary>{}</summary><pre>{}</pre></details></td>", tag, text,
                     html_escaped(cell.details));
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

Cell bad_if(bool is_bad, const std::string& text) {
  Cell cell(text);
  cell.is_bad = is_bad;
  return cell;
}

std::string html_of(const Table& table) {
  std::string html = "<div class=\"scroll\"><table><thead><tr>";
  for (const auto& head : table.heads) html += fmt::format("<th>{}</th>", head);
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const auto& cell : row) html += html_of(cell);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string text_of(const Table& table) {
  auto rows = table.rows;
  rows.insert(rows.begin(), {table.heads.begin(), table.heads.end()});
  std::vector<std::size_t> widths(table.heads.size(), 0);
  std::vector<bool> to_the_left(table.heads.size(), false);
  to_the_left.front() = true;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      widths[k] = std::max(widths[k], width_of(row[k].text));
      if (row[k].is_words) to_the_left[k] = true;
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string blanks(widths[k] - width_of(row[k].text), ' ');
      line += (k == 0 ? "" : "  ") + (to_the_left[k] ? row[k].text + blanks : blanks + row[k].text);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string number_text(const nlohmann::ordered_json& value, const char* format) {
  return value.is_number() && std::isfinite(value.get<double>())
             ? fmt::format(fmt::runtime(format), value.get<double>())
             : "–";
}

}  // namespace fretval
