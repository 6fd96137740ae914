#pragma once

#include <map>
#include <string>
#include <utility>

namespace fretval {

/// Texts of entries as case files set them, by section and name.
class EntryTexts {
 public:
  void set(const std::string& section, const std::string& name, std::string text) {
    texts_[{section, name}] = std::move(text);
  }
  /// Sets all entries of another file, which replace those that are set already.
  void override_by(const EntryTexts& other) {
    for (const auto& [key, text] : other.texts_) texts_[key] = text;
  }
  /// The text of an entry; empty if it is not set.
  [[nodiscard]] std::string text(const std::string& section, const std::string& name) const {
    const auto found = texts_.find({section, name});
    return found == texts_.end() ? "" : found->second;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::string> texts_;
};

}  // namespace fretval
