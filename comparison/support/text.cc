#include "comparison/support/text.h"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <utility>

namespace fretval {
namespace {

constexpr std::size_t longest_word = 60;  // nobody mistypes more

std::string lower(std::string word) {
  for (char& c : word) c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// Insertions, deletions, replacements and swaps of neighbours that make b of a (optimal string alignment).
std::size_t n_edits(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      auto& here = edits[i][j];
      if (i == 0 || j == 0) {
        here = i + j;
        continue;
      }
      here = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        here = std::min(here, edits[i - 2][j - 2] + 1);
    }
  return edits[a.size()][b.size()];
}

}  // namespace

std::string closest(const std::string& word, const std::vector<std::string>& candidates, double share) {
  if (word.empty() || word.size() > longest_word) return "";
  std::string best;
  std::size_t fewest = longest_word;
  for (const auto& candidate : candidates) {
    const auto edits = n_edits(lower(word), lower(candidate));
    const auto most = share * static_cast<double>(std::max(word.size(), candidate.size()));
    if (edits >= fewest || static_cast<double>(edits) > most) continue;
    fewest = edits;
    best = candidate;
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto best = closest(word, candidates);
  return best.empty() ? "" : "; did you mean " + best + "?";
}

std::string html_escaped(const std::string& text) {
  auto result = text;
  for (const auto& [sign, entity] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    boost::replace_all(result, sign, entity);
  return result;
}

std::string without_control_characters(std::string text) {
  for (char& c : text)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\n') || c == 0x7F) c = '?';
  return text;
}

}  // namespace fretval
