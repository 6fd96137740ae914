#pragma once

#include <string>
#include <vector>

#include "comparison/case.h"

namespace dealii {
class ParameterHandler;
}

namespace fretval {

/// What a number in a case file may be, and how to say so.
struct ValidNumber {
  bool (*accepts)(double);
  const char* description;
};

extern const ValidNumber any_number;

/// Declares every entry of a case file, all without a default: what is not set is an error where it is needed.
void declare_entries(dealii::ParameterHandler& handler);

bool is_entry(const std::string& section, const std::string& name);

/// "Indenter: Shape, Radius, ...; Elastomer: ...", for error messages.
std::string valid_entries();

/// Typed access to a parsed case file. Every failure is an InputError naming file, entry, value and what would be
/// valid.
class EntryReader {
 public:
  EntryReader(dealii::ParameterHandler& handler, std::string file) : handler_(handler), file_(std::move(file)) {}

  [[nodiscard]] bool given(const std::string& section, const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& section, const std::string& name) const;
  [[nodiscard]] std::string one_of(const std::string& section, const std::string& name,
                                   const std::vector<std::string>& choices) const;
  [[nodiscard]] double number(const std::string& section, const std::string& name, const ValidNumber& valid) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& section, const std::string& name,
                                            const ValidNumber& valid) const;
  /// An entry that contradicts another one.
  void forbid(const std::string& section, const std::string& name, const std::string& reason) const;
  [[noreturn]] void fail(const std::string& section, const std::string& name, const std::string& valid) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  dealii::ParameterHandler& handler_;
  std::string file_;
};

/// Everything but the name. fields: what to write when the file does not say.
Case read_entries(const EntryReader& entries, Case::Fields fields);

}  // namespace fretval
