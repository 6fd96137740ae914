#include "comparison/case_file/entry_lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "comparison/case/case.h"
#include "comparison/support/text.h"
#include "mdr/support/trimmed.h"

namespace fretval {
namespace {

using D = Dimension;

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const auto& section : case_sections()) names.emplace_back(section.name);
  return names;
}

std::string names_in(const SectionTraits& section) {
  return fmt::format("{}", fmt::join(names_but(section.name, {}), ", "));
}

std::string lower_letters(const std::string& text) {
  std::string letters;
  for (const char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

/// A hint as a sentence, with the full stop that it may lack, and a blank.
std::string as_sentence(const std::string& hint) {
  return hint + (!hint.empty() && hint.back() == '?' ? " " : ". ");
}

/// What people write who come from other programs.
std::string known_elsewhere(const std::string& name) {
  const auto letters = lower_letters(name);
  if (letters.find("poisson") != std::string::npos || letters == "nu")
    return "; write Elastomer / Poisson ratio = 0.49, say; it is 1/2 where it is not set";
  if (letters.find("young") != std::string::npos || letters == "e")
    return "; write Relaxed shear modulus = E/3, or E/(2 (1 + ν)) with an Elastomer / Poisson ratio";
  return "";
}

struct Meant {
  std::string here;                    ///< in the section that it stands in; empty: none is near
  std::vector<std::string> elsewhere;  ///< with their sections
};

/// An entry of the section itself may be spelled worse than one of another section, unless that is spelled right.
Meant entry_meant(const std::string& section, const std::string& name) {
  constexpr double half = 0.5;
  std::vector<std::string> here;
  Meant meant;
  bool is_right_elsewhere = false;
  for (const auto& other : case_sections())
    for (const auto& entry : other.entries) {
      if (other.name == section)
        here.emplace_back(entry.name);
      else if (closest(name, {entry.name}) == entry.name) {
        meant.elsewhere.push_back(fmt::format("{} / {}", other.name, entry.name));
        is_right_elsewhere = is_right_elsewhere || closest(name, {entry.name}, 0) == entry.name;
      }
    }
  meant.here = closest(name, here);
  if (meant.here.empty() && !is_right_elsewhere) meant.here = closest(name, here, half);
  return meant;
}

}  // namespace

const SectionTraits* find_section(const std::string& name) {
  for (const auto& section : case_sections())
    if (section.name == name) return &section;
  return nullptr;
}

const EntryTraits* find_entry(const std::string& section, const std::string& name) {
  const auto* found = find_section(section);
  if (!found) return nullptr;
  for (const auto& entry : found->entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

const EntryTraits* find_entry(const std::string& place) {
  const auto [section, entry] = place_of(place);
  return find_entry(section, entry);
}

EntryPlace place_of(const std::string& text) {
  const auto at = text.find('/');
  if (at == std::string::npos) return {text, ""};
  return {trimmed(text.substr(0, at)), trimmed(text.substr(at + 1))};
}

bool is_entry(const std::string& section, const std::string& name) {
  return find_entry(section, name) != nullptr;
}

std::vector<std::string> names_but(const std::string& section, const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const auto& entry : find_section(section)->entries)
    if (std::find(others.begin(), others.end(), entry.name) == others.end()) names.emplace_back(entry.name);
  return names;
}

std::string valid_entries() {
  std::string list;
  for (const auto& section : case_sections())
    list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", section.name, names_in(section));
  return list;
}

std::string no_such_section(const std::string& section, Problems& problems) {
  problems.meant.insert(closest(section, section_names()));
  return fmt::format("subsection {}: no such subsection{}Valid subsections: {}", section,
                     as_sentence(did_you_mean(section, section_names())), fmt::join(section_names(), ", "));
}

std::string no_such_entry(const std::string& section, const std::string& name, Problems& problems) {
  const auto meant = entry_meant(section, name);
  problems.meant.insert(section + " / " + meant.here);
  std::string hint = known_elsewhere(name);
  if (hint.empty() && !meant.here.empty()) hint = "; did you mean " + meant.here + "?";
  if (hint.empty() && !meant.elsewhere.empty())
    hint = fmt::format("; did you mean {}?", fmt::join(meant.elsewhere, " or "));
  const auto* owner = find_section(section);
  return fmt::format("{}{}: no such entry{}Valid entries{}: {}", section.empty() ? "" : section + " / ", name,
                     as_sentence(hint), owner ? std::string(" of ") + owner->name : "",
                     owner ? names_in(*owner) : valid_entries());
}

std::string entries_reference() {
  std::string text =
      "# Entries of a case file\n\n`fretval explain --entries` prints this page; `fretval new` writes a case file to "
      "begin with.\n\nA case file (`.prm`) has subsections of entries, `set NAME = VALUE`; what follows a # is a "
      "comment. `include FILE` lines\nbefore the first subsection take over another file, whose entries may be set "
      "again. The same in JSON: sections as objects\nof entries, lists as arrays.\n\nNumbers may have a unit of what "
      "the entry measures; without one they are in the unit of the table. In a list each number\nhas a unit, or none, "
      "or the last one for all.\n\n*An error* where an entry is not set: only where the case needs it. Where some "
      "shapes, rheologies or laws\nalone need it, the meaning names them.\n\n| measured in | also |\n| --- | --- |\n";
  for (const auto dimension : {D::length, D::frequency, D::pressure, D::time, D::angle, D::viscosity, D::force,
                               D::temperature, D::difference, D::wear_rate})
    text += fmt::format("| {} | {} |\n", base_unit(dimension), other_units(dimension));
  for (const auto& section : case_sections()) {
    text += fmt::format(
        "\n## {}\n\n| entry | values | unit | where it is not set | meaning |\n| --- | --- | --- | --- | --- |\n",
        section.name);
    for (const auto& entry : section.entries) {
      std::vector<std::string> units;
      for (const auto dimension : entry.dimensions) units.push_back(base_unit(dimension));
      text += fmt::format("| {} | {} | {} | {} | {} |\n", entry.name, entry.values.text, fmt::join(units, ", "),
                          entry.without, entry.about);
    }
  }
  return text;
}

void Problems::add(const std::string& message) {
  if (std::find(messages.begin(), messages.end(), message) == messages.end()) messages.push_back(message);
}

void Problems::throw_if_any() const {
  if (!messages.empty()) throw InputError(fmt::format("{}", fmt::join(messages, "\n")));
}

}  // namespace fretval
