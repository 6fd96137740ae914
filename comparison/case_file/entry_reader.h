#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "comparison/case_file/entry_lookup.h"
#include "comparison/case_file/file_entries.h"

namespace fretval {

/// Typed access to a parsed case file. What an entry may be is in entry_table.h. Every failure becomes a problem that
/// names file, entry, value and what would be valid, and reading goes on with what the functions below return then;
/// call throw_problems() at the end. Numbers may have a unit of what the entry measures.
class EntryReader {
 public:
  EntryReader(const EntryTexts& entries, std::string file, Problems& problems)
      : entries_(entries), file_(std::move(file)), problems_(problems) {}

  [[nodiscard]] bool given(const std::string& section, const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& section, const std::string& name) const;
  /// One of the words of the entry; empty if it is none of them.
  [[nodiscard]] std::string word(const std::string& section, const std::string& name) const;
  /// The word of an entry whose words are those of an enumeration, in its order; empty if it is none of them.
  template <class Enumeration>
  [[nodiscard]] std::optional<Enumeration> kind(const std::string& section, const std::string& name) const {
    const auto position = position_of_word(section, name);
    return position ? std::optional(static_cast<Enumeration>(*position)) : std::nullopt;
  }
  /// Whether the entry is set, and to this word.
  [[nodiscard]] bool says(const std::string& section, const std::string& name, const std::string& expected) const;
  /// A number in SI units (degrees, Hz); NaN if it is not valid.
  [[nodiscard]] double number(const std::string& section, const std::string& name) const;
  /// A whole number; 0 if it is not valid.
  [[nodiscard]] unsigned whole(const std::string& section, const std::string& name) const;
  /// A list; empty if one of them is not valid. Either all have a unit, or none, or the last one alone, whose unit
  /// holds for all then.
  [[nodiscard]] std::vector<double> numbers(const std::string& section, const std::string& name) const;
  /// A list of numbers that another entry holds as text, in the units of this entry.
  [[nodiscard]] std::vector<double> numbers_for(const std::string& section, const std::string& name,
                                                const std::string& text, char separator) const;
  /// Which units numbers of an entry may have, for messages.
  [[nodiscard]] std::string units_of(const std::string& section, const std::string& name) const;
  /// Path of a file that is named relative to the case file; empty if there is none.
  [[nodiscard]] std::string path(const std::string& section, const std::string& name) const;
  /// Forbids the entries of a section that do not belong to this word of its first one, and reads those that do into
  /// their fields of a part of the case.
  template <class Part>
  void read_fields(const std::string& section, const std::string& owner, Part& part) const {
    forbid_others(section, owner);
    for (const auto& entry : find_section(section)->entries) {
      const auto* field = std::get_if<double Part::*>(&entry.field);
      if (field && entry.belongs_to(owner) && (entry.is_needed() || given(section, entry.name)))
        part.*(*field) = number(section, entry.name);
    }
  }
  /// Notes a problem if an entry is set that contradicts another one.
  void forbid(const std::string& section, const std::string& name, const std::string& reason) const;
  void forbid_all(const std::string& section, const std::vector<std::string>& names, const std::string& reason) const {
    for (const auto& name : names) forbid(section, name, reason);
  }
  void fail(const std::string& section, const std::string& name, const std::string& valid) const;
  void add_problem(const std::string& message) const { problems_.add(message); }
  /// Throws InputError if anything has failed.
  void throw_problems() const { problems_.throw_if_any(); }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  [[nodiscard]] std::optional<std::size_t> position_of_word(const std::string& section, const std::string& name) const;
  void forbid_others(const std::string& section, const std::string& owner) const;

  const EntryTexts& entries_;
  std::string file_;
  Problems& problems_;
};

}  // namespace fretval
