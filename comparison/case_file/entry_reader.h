#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/case_file/entry_texts.h"
#include "comparison/case_file/problems.h"

namespace fretval {

/// What a number in a case file may be, and how to say so.
struct ValidNumber {
  bool (*accepts)(double);
  const char* description;
};

extern const ValidNumber any_number;
extern const ValidNumber positive_number;
extern const ValidNumber not_negative_number;

/// Typed access to a parsed case file. Every failure becomes a problem that names file, entry, value and what would be
/// valid, and reading goes on with what the functions below return then; call throw_problems() at the end. Numbers may
/// have a unit of what the entry measures (see entry_table.h).
class EntryReader {
 public:
  EntryReader(const EntryTexts& entries, std::string file, Problems& problems)
      : entries_(entries), file_(std::move(file)), problems_(problems) {}

  [[nodiscard]] bool given(const std::string& section, const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& section, const std::string& name) const;
  /// Empty if it is none of them.
  [[nodiscard]] std::string one_of(const std::string& section, const std::string& name,
                                   const std::vector<std::string>& choices) const;
  /// NaN if it is not valid.
  [[nodiscard]] double number(const std::string& section, const std::string& name, const ValidNumber& valid) const;
  /// A whole number; 0 if it is not valid.
  [[nodiscard]] unsigned whole(const std::string& section, const std::string& name, const ValidNumber& valid) const;
  /// A list; empty if one of them is not valid. Either all have a unit, or none, or the last one alone, whose unit
  /// holds for all then.
  [[nodiscard]] std::vector<double> numbers(const std::string& section, const std::string& name,
                                            const ValidNumber& valid) const;
  /// The same of a text that stands in one entry, separated, and is for another one, whose units it has.
  [[nodiscard]] std::vector<double> numbers_for(const std::string& section, const std::string& name,
                                                const std::string& text, char separator) const;
  /// Which units numbers of an entry may have, for messages.
  [[nodiscard]] std::string units_of(const std::string& section, const std::string& name) const;
  /// Path of a file that is named relative to the case file; empty if there is none.
  [[nodiscard]] std::string path(const std::string& section, const std::string& name) const;
  /// An entry that contradicts another one.
  void forbid(const std::string& section, const std::string& name, const std::string& reason) const;
  void fail(const std::string& section, const std::string& name, const std::string& valid) const;
  void add_problem(const std::string& message) const { problems_.add(message); }
  /// Throws InputError if anything has failed.
  void throw_problems() const { problems_.throw_if_any(); }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  const EntryTexts& entries_;
  std::string file_;
  Problems& problems_;
};

}  // namespace fretval
