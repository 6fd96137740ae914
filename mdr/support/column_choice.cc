#include "mdr/support/column_choice.h"

#include <algorithm>
#include <cctype>

#include "mdr/support/csv.h"
#include "mdr/support/csv_units.h"
#include "mdr/support/trimmed.h"

namespace fretval::mdr {

namespace {

bool is_unit_of(const std::string& unit, const ColumnKind& kind) {
  return kind.units.count(unit) > 0;
}

}  // namespace

bool is_any_unit(const std::string& unit, const std::vector<WantedColumn>& wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const WantedColumn& one) {
    return std::any_of(one.kinds.begin(), one.kinds.end(),
                       [&](const ColumnKind& kind) { return is_unit_of(unit, kind); });
  });
}

std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string shown(const Column& column) {
  const auto name = column.name.empty() ? std::string("(without a name)") : column.name;
  const bool is_told = column.unit.empty() || unit_text(column.name) == column.unit;
  return is_told ? name : name + " [" + column.unit + "]";
}

std::string simplified_name(const std::string& name) {
  std::string simple;
  const auto bracket = name.find_first_of("[(");
  for (const char c : name.substr(0, bracket == 0 ? std::string::npos : bracket)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || c == '\t' || c == '_' || c == '-' || c == '.') continue;
    simple += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
  }
  // All characters that are written for the prime of G'.
  for (const char* stroke : {"\u2032", "\u2019", "\u2018", "\u00b4", "`"})
    for (auto at = simple.find(stroke); at != std::string::npos; at = simple.find(stroke))
      simple.replace(at, std::string(stroke).size(), "'");
  for (const char* strokes : {"\u2033", "\u201d", "\""})
    for (auto at = simple.find(strokes); at != std::string::npos; at = simple.find(strokes))
      simple.replace(at, std::string(strokes).size(), "''");
  return simple;
}

namespace {

bool matches(const std::string& name, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& one) {
    return one.back() == '*' ? name.compare(0, one.size() - 1, one, 0, one.size() - 1) == 0 : name == one;
  });
}

std::string all_names(const Header& header) {
  std::vector<std::string> names;
  for (const auto& column : header) names.push_back(shown(column));
  return list_of(names);
}

/// "f / Hz" names a unit behind the stroke, if it is one.
Column column_of(const std::string& name, const std::string* unit, const std::vector<WantedColumn>& wanted) {
  const auto bracketed = unit_text(name);
  // Brackets of a name like "tan(delta)" hold no unit.
  const bool is_bracketed =
      bracketed != name && (is_any_unit(bracketed, wanted) || simplified_name(name).compare(0, 3, "tan") != 0);
  if (unit != nullptr && (!unit->empty() || !is_bracketed)) return {name, unit_text(*unit), true};
  if (is_bracketed) return {name, bracketed, true};
  const auto stroke = name.find('/');
  if (stroke != std::string::npos && stroke > 0) {
    const auto behind = trimmed(name.substr(stroke + 1));
    if (is_any_unit(behind, wanted)) return {trimmed(name.substr(0, stroke)), behind, true};
  }
  return {name.substr(0, name.find_first_of("[(")), "", false};
}

/// The columns that have a name of the kind.
std::vector<std::size_t> named(const Header& header, const ColumnKind& kind) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < header.size(); ++i)
    if (matches(simplified_name(header[i].name), kind.names)) columns.push_back(i);
  return columns;
}

std::string quantities_of(const WantedColumn& wanted) {
  std::string text;
  for (const auto& kind : wanted.kinds) text += (text.empty() ? "" : " or ") + kind.quantity;
  return text;
}

std::string units_of(const WantedColumn& wanted) {
  std::vector<std::string> units;
  for (const auto& kind : wanted.kinds)
    for (const auto& [unit, size] : kind.units)
      if (!unit.empty() && std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
  return list_of(units);
}

std::optional<Choice> choice_by_name(const Header& header, const WantedColumn& wanted) {
  std::optional<Choice> choice;
  for (std::size_t kind = 0; kind < wanted.kinds.size(); ++kind) {
    auto columns = named(header, wanted.kinds[kind]);
    const auto has_other_unit = [&](std::size_t i) {
      return header[i].has_unit && !is_unit_of(header[i].unit, wanted.kinds[kind]);
    };
    // The only one that is called so is meant, and its unit is refused by name; of several, those with a known unit.
    const bool is_of_other_kind = columns.size() == 1 && has_other_unit(columns[0]) &&
                                  std::any_of(wanted.kinds.begin(), wanted.kinds.end(), [&](const ColumnKind& other) {
                                    return is_unit_of(header[columns[0]].unit, other) &&
                                           matches(simplified_name(header[columns[0]].name), other.names);
                                  });
    if (columns.size() > 1 || is_of_other_kind)
      columns.erase(std::remove_if(columns.begin(), columns.end(), has_other_unit), columns.end());
    if (columns.empty()) continue;
    if (columns.size() > 1)
      throw NotClear("which column is the " + wanted.kinds[kind].quantity +
                     " is not clear: " + shown(header[columns[0]]) + " or " + shown(header[columns[1]]));
    if (choice && (wanted.first_kind_goes_first || choice->column == columns[0])) continue;
    if (choice)
      throw NotClear("has a column " + shown(header[choice->column]) + " and a column " + shown(header[columns[0]]) +
                     ", of which one alone can be prescribed; leave one of them out");
    choice = Choice{columns[0], kind};
  }
  return choice;
}

/// Columns that nothing has been taken for, with a unit of one of the kinds.
std::vector<Choice> choices_by_unit(const Header& header, const WantedColumn& wanted, const Choices& taken) {
  std::vector<Choice> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_taken =
        std::any_of(taken.begin(), taken.end(), [i](const auto& choice) { return choice && choice->column == i; });
    const auto name = simplified_name(header[i].name);
    const bool is_logarithm = name.compare(0, 3, "log") == 0 || name.compare(0, 2, "lg") == 0;
    if (is_taken || is_logarithm || !header[i].has_unit || header[i].unit.empty()) continue;
    for (std::size_t kind = 0; kind < wanted.kinds.size(); ++kind)
      if (is_unit_of(header[i].unit, wanted.kinds[kind])) {
        found.push_back({i, kind});
        break;
      }
  }
  return found;
}

[[noreturn]] void refuse_missing(const Header& header, const WantedColumn& wanted) {
  throw NotClear("has no column for the " + quantities_of(wanted) + ", in " + units_of(wanted) + "; its columns are " +
                 all_names(header));
}

[[noreturn]] void refuse_unclear(const Header& header, const WantedColumn& wanted, const std::vector<Choice>& found) {
  throw NotClear("which column is the " + quantities_of(wanted) + " is not clear: " + shown(header[found[0].column]) +
                 " or " + shown(header[found[1].column]) + "; name it " + wanted.kinds[0].names[0]);
}

/// Takes the remaining columns in their order, if none has a unit and there are no others.
void take_in_order(const Header& header, const std::vector<WantedColumn>& wanted, Choices& choices) {
  const auto n_needed =
      std::count_if(wanted.begin(), wanted.end(), [](const WantedColumn& one) { return !one.is_optional; });
  const bool any_unit_or_number = std::any_of(header.begin(), header.end(), [](const Column& column) {
    return column.has_unit || begins_like_number(column.name);
  });
  if (any_unit_or_number || n_needed != static_cast<std::ptrdiff_t>(header.size())) return;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (choices[k] || wanted[k].is_optional) continue;
    for (std::size_t column = 0; !choices[k] && column < header.size(); ++column) {
      const bool is_taken = std::any_of(choices.begin(), choices.end(),
                                        [column](const auto& choice) { return choice && choice->column == column; });
      if (!is_taken) choices[k] = Choice{column, 0};
    }
  }
}

}  // namespace

Header header_of(const std::vector<std::string>& names, const std::vector<std::string>& units,
                 const std::vector<WantedColumn>& wanted) {
  Header header;
  for (std::size_t i = 0; i < names.size(); ++i)
    header.push_back(column_of(names[i], i < units.size() ? &units[i] : nullptr, wanted));
  return header;
}

Choices choices_of(const Header& header, const std::vector<WantedColumn>& wanted, InOrder in_order,
                   bool may_lack_units) {
  Choices choices;
  for (const auto& one : wanted) choices.push_back(choice_by_name(header, one));
  if (in_order == InOrder::yes && may_lack_units) take_in_order(header, wanted, choices);
  // Columns are found in rounds, as one that is found by its unit may leave a single column for another quantity.
  for (bool any = true; any;) {
    any = false;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (choices[k] || wanted[k].is_optional) continue;
      const auto found = choices_by_unit(header, wanted[k], choices);
      if (found.empty()) refuse_missing(header, wanted[k]);
      std::size_t n_that_could_be = 0;
      for (std::size_t other = 0; other < wanted.size(); ++other) {
        if (choices[other] || wanted[other].is_optional) continue;
        const auto of_other = choices_by_unit(header, wanted[other], choices);
        n_that_could_be += std::any_of(of_other.begin(), of_other.end(),
                                       [&](const Choice& choice) { return choice.column == found[0].column; });
      }
      const bool one_for_one = found.size() == 1 && n_that_could_be == 1;
      const bool as_many = in_order == InOrder::yes && found.size() == n_that_could_be;
      if (!one_for_one && !as_many) continue;
      choices[k] = found[0];
      any = true;
    }
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (choices[k] || wanted[k].is_optional) continue;
    const auto found = choices_by_unit(header, wanted[k], choices);
    if (found.size() < 2) refuse_missing(header, wanted[k]);
    refuse_unclear(header, wanted[k], found);
  }
  for (std::size_t k = 0; k < choices.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (choices[k] && choices[j] && choices[k]->column == choices[j]->column)
        throw NotClear("takes the column " + shown(header[choices[k]->column]) + " for two quantities, the " +
                       quantities_of(wanted[j]) + " and the " + quantities_of(wanted[k]));
  return choices;
}

}  // namespace fretval::mdr
