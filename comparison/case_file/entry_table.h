#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/case_file/units.h"

namespace fretval {

/// What a number in a case file may be.
struct ValidNumber {
  bool (*accepts)(double);
  const char* description;  ///< in messages: "a positive number"
  const char* brief;        ///< in the reference of all entries: "positive"
};

/// What an entry may be: numbers, one of some words, or what its text says and code of its own reads.
struct EntryValues {
  EntryValues(const char* text_) : text(text_) {}
  EntryValues(const ValidNumber& number_, const char* and_more = "")
      : text(std::string(number_.brief) + and_more), number(number_) {}
  EntryValues(std::initializer_list<const char*> words_) : EntryValues(words_.begin(), words_.end()) {}
  template <std::size_t n>
  EntryValues(const std::array<const char*, n>& words_) : EntryValues(words_.begin(), words_.end()) {}

  std::string text;  ///< in the reference of all entries
  std::optional<ValidNumber> number;
  std::vector<std::string> words;

 private:
  EntryValues(const char* const* first, const char* const* last);
};

/// Where a part of a case keeps the number of an entry.
using Field = std::variant<std::monostate, double Case::Indenter::*, double Case::Elastomer::*, double Case::Body::*>;

/// An entry of a case file. This table is the only place that lists them: reading, messages, the listing of what a case
/// has and docs/case_file.md (`fretval explain --entries`) follow it (comparison/case_file/entry_lookup.h).
struct EntryTraits {
  const char *name, *symbol;          ///< symbol: of the axis of a sweep, "u_{x0}"; empty: its name has to do
  std::vector<Dimension> dimensions;  ///< of its number, or in turn of the numbers of its list; empty: a word
  EntryValues values;                 ///< what it may be
  const char* without;                ///< what holds where the entry is not set
  const char* about;
  std::vector<std::string> owners = {};  ///< words of the section's first entry that it belongs to; empty: all
  /// The member that keeps the number of the entry; an entry whose member has the value of a new Case counts as not
  /// set. Empty: the number is read and listed by code of its own.
  Field field = {};

  [[nodiscard]] bool belongs_to(const std::string& owner) const {
    return owners.empty() || std::find(owners.begin(), owners.end(), owner) != owners.end();
  }
  /// Whether a file is wrong without it, where it has a meaning.
  [[nodiscard]] bool is_needed() const { return std::string("an error") == without; }
};

struct SectionTraits {
  const char* name;
  std::vector<EntryTraits> entries;
};

const std::vector<SectionTraits>& case_sections();

}  // namespace fretval
