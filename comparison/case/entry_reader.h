#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

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
extern const ValidNumber positive_number;
extern const ValidNumber not_negative_number;

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
  /// Path of a file that is named relative to the case file.
  [[nodiscard]] std::string path(const std::string& section, const std::string& name) const;
  /// An entry that contradicts another one.
  void forbid(const std::string& section, const std::string& name, const std::string& reason) const;
  [[noreturn]] void fail(const std::string& section, const std::string& name, const std::string& valid) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  dealii::ParameterHandler& handler_;
  std::string file_;
};

}  // namespace fretval
