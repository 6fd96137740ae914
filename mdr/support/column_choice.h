#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace fretval::mdr {

/// A column that a table may have: what it is called and in which units.
struct ColumnKind {
  std::string quantity;  ///< for messages, "storage modulus"
  /// Names as simplified_name() makes them; "stor*" stands for any name that begins so.
  std::vector<std::string> names;
  std::map<std::string, double> units;  ///< their sizes in the base unit
};

/// A column that a table has to have: one of some kinds.
struct WantedColumn {
  std::vector<ColumnKind> kinds;
  bool is_optional = false;
  bool first_kind_goes_first = false;  ///< of several columns the first kind is meant; false: that is not clear
};

/// Whether columns that neither a name nor a unit tells from each other are taken in the order in which they are
/// wanted, if there are as many.
enum class InOrder { no, yes };

/// A column of a table, by its line of names and the units that it or the line below names.
struct Column {
  std::string name, unit;  ///< as in the file
  bool has_unit;
};
using Header = std::vector<Column>;

/// Which column of a table a wanted one is, and of which of its kinds.
struct Choice {
  std::size_t column, kind;
};
using Choices = std::vector<std::optional<Choice>>;

/// Why a header does not have the wanted columns.
struct NotClear : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

bool is_any_unit(const std::string& unit, const std::vector<WantedColumn>& wanted);

/// The words separated by commas, "T, set".
std::string list_of(const std::vector<std::string>& words);

/// Name and unit, for messages.
std::string shown(const Column& column);

/// units: the line of units; empty: there is none, and units stand in brackets or behind a stroke.
Header header_of(const std::vector<std::string>& names, const std::vector<std::string>& units,
                 const std::vector<WantedColumn>& wanted);

/// Which column each wanted one is: by name, or else by unit where that leaves no doubt. may_lack_units: whether names
/// without any units may be taken in their order. Throws NotClear.
Choices choices_of(const Header& header, const std::vector<WantedColumn>& wanted, InOrder in_order,
                   bool may_lack_units);

/// The name in lower case, without unit, blanks, hyphens, underscores and full stops: "E_stor [MPa]" is "estor".
std::string simplified_name(const std::string& name);

}  // namespace fretval::mdr
