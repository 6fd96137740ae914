#include "comparison/case/case_file.h"

#include <deal.II/base/parameter_handler.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "comparison/case/case_entries.h"
#include "comparison/case/trimmed.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_characters = 1'000'000;
constexpr std::size_t most_includes = 100;

std::string read_text(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(fmt::format("{}: no such file", file.string()));
  if (!fs::is_regular_file(file, error)) throw InputError(fmt::format("{}: not a file", file.string()));
  const auto size = fs::file_size(file, error);
  if (!error && size > most_characters)
    throw InputError(
        fmt::format("{}: has {} bytes, must be a case file of at most {}", file.string(), size, most_characters));
  std::ifstream stream(file);
  std::stringstream content;
  if (!(content << stream.rdbuf())) throw InputError(fmt::format("{}: empty or not readable", file.string()));
  std::string text = content.str();
  if (text.find('\0') != std::string::npos)
    throw InputError(fmt::format("{}: holds a zero byte, must be a text file", file.string()));
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // a byte order mark
  return text;
}

std::string first_sentence(const dealii::ExceptionBase& error) {
  std::istringstream text(error.what());
  std::string line, message;
  bool inside = false;
  while (std::getline(text, line)) {
    if (line.find("Additional information:") != std::string::npos) {
      inside = true;
      continue;
    }
    if (!inside) continue;
    if (line.find("------") != std::string::npos || line.find("Stacktrace") != std::string::npos) break;
    const auto begin = line.find_first_not_of(' ');
    if (begin != std::string::npos) message += (message.empty() ? "" : " ") + line.substr(begin);
  }
  while (!message.empty() && message.back() == '.') message.pop_back();
  // deal.II begins with "Line <6> of file <case.prm>: ", and sometimes forgets the last bracket.
  const auto number_end = message.find("> of file <"), place_end = message.find(": ");
  if (message.rfind("Line <", 0) != 0 || number_end == std::string::npos || place_end == std::string::npos)
    return message;
  return "line " + message.substr(6, number_end - 6) + message.substr(place_end);
}

/// Words of a name separated by single blanks.
std::string name_in(const std::string& text) {
  std::istringstream words(text);
  std::string name;
  for (std::string word; words >> word;) name += (name.empty() ? "" : " ") + word;
  return name;
}

/// What a file says by itself: which files it includes, and its lines without those, so that numbers stay right.
class Lines {
 public:
  explicit Lines(const fs::path& file) : file_(file) {
    std::istringstream stream(read_text(file));
    std::string logical;  // a line that ends in a backslash goes on in the next
    for (std::string line; std::getline(stream, line);) {
      ++n_read_;
      logical += trimmed(line.substr(0, line.find('#')));
      if (!logical.empty() && logical.back() == '\\') {
        logical.pop_back();
        text_ += '\n';
        continue;
      }
      take(logical);
      logical.clear();
    }
    if (!logical.empty()) take(logical);
  }

  [[nodiscard]] const std::vector<fs::path>& included() const { return included_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: line {}: {}", file_.string(), n_read_, problem));
  }

  void take(const std::string& line) {
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    std::getline(words, rest);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (word == "include") {
      include(trimmed(rest));
      text_ += '\n';
      return;
    }
    if (word == "subsection") sections_.push_back(name_in(rest));
    if (word == "end" && !sections_.empty()) sections_.pop_back();
    if (word == "set") take_entry(name_in(rest.substr(0, rest.find('='))));
    text_ += line + '\n';
  }

  void include(const std::string& name) {
    if (name.empty()) fail("the include line names no file");
    if (!sections_.empty() || !line_of_entry_.empty())
      fail(fmt::format("include {} must stand before the first subsection", name));
    included_.push_back(file_.parent_path() / name);
    std::error_code error;
    if (!fs::exists(included_.back(), error))
      fail(fmt::format("include {}: no such file as {}", name, included_.back().string()));
  }

  void take_entry(const std::string& name) {
    const std::string full = fmt::format("{} / {}", fmt::join(sections_, " / "), name);
    const auto [found, is_new] = line_of_entry_.emplace(full, n_read_);
    if (!is_new) fail(fmt::format("{} is set a second time, first in line {}; must be set once", full, found->second));
  }

  fs::path file_;
  std::vector<fs::path> included_;
  std::string text_;
  int n_read_ = 0;
  std::vector<std::string> sections_;
  std::map<std::string, int> line_of_entry_;
};

/// Sections of entries: {"Indenter": {"Shape": "cone", "Slope angle": 5}}.
void parse_json(const fs::path& file, dealii::ParameterHandler& handler) {
  using nlohmann::json;
  std::vector<std::set<std::string>> keys;  // by depth, to refuse a key that comes twice
  std::string current;
  const auto check = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event != json::parse_event_t::key) return true;
    const auto key = value.get<std::string>();
    if (depth == 1) current = key;
    if (!keys.back().insert(key).second)
      throw InputError(fmt::format("{}: {}{} is there a second time; must be there once", file.string(),
                                   depth == 1 ? "" : current + " / ", key));
    return true;
  };
  json sections;
  try {
    sections = json::parse(read_text(file), check);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (!sections.is_object()) throw InputError(fmt::format("{}: must be a JSON object of sections", file.string()));
  for (const auto& [section, entries] : sections.items()) {
    if (!entries.is_object())
      throw InputError(fmt::format("{}: {}: must be a JSON object of entries", file.string(), section));
    for (const auto& [name, value] : entries.items()) {
      if (!is_entry(section, name))
        throw InputError(fmt::format("{}: {} / {}: no such entry. Valid entries: {}", file.string(), section, name,
                                     valid_entries()));
      if (!value.is_string() && !value.is_number() && !value.is_boolean())
        throw InputError(
            fmt::format("{}: {} / {}: must be text, a number, true or false", file.string(), section, name));
      handler.enter_subsection(section);
      handler.set(name, value.is_string() ? value.get<std::string>() : value.dump());
      handler.leave_subsection();
    }
  }
}

/// name: of the file, for messages.
void parse_text(const std::string& text, const fs::path& name, dealii::ParameterHandler& handler) {
  try {
    std::istringstream stream(text);
    handler.parse_input(stream, name.string());
  } catch (const dealii::ExceptionBase& error) {
    throw InputError(fmt::format("{}: {}. Valid entries: {}", name.string(), first_sentence(error), valid_entries()));
  } catch (const std::exception& error) {
    throw InputError(fmt::format("{}: {}", name.string(), error.what()));
  }
}

/// Reads a file after those that it includes. chain: the files that include it.
class Parser {
 public:
  explicit Parser(dealii::ParameterHandler& handler) : handler_(handler) {}

  void parse(const fs::path& file, std::vector<fs::path> chain) {
    const fs::path canonical = fs::weakly_canonical(file);
    if (std::find(chain.begin(), chain.end(), canonical) != chain.end())
      throw InputError(fmt::format("{}: the file includes itself", file.string()));
    chain.push_back(canonical);
    if (++n_files_ > most_includes)
      throw InputError(fmt::format("{}: more than {} files are included", chain.front().string(), most_includes));
    if (file.extension() == ".json") return parse_json(file, handler_);
    const Lines lines(file);
    for (const auto& included : lines.included()) parse(included, chain);
    parse_text(lines.text(), file, handler_);
  }

 private:
  dealii::ParameterHandler& handler_;
  std::size_t n_files_ = 0;
};

/// The name of a case is that of its folder of results, and stands in JSON and HTML.
std::string case_name(const fs::path& file) {
  std::string name = file.stem().string();
  const auto refuse = [&](const char* reason) {
    throw InputError(fmt::format("{}: the name of a case file becomes that of a folder of results, and {}; rename it",
                                 file.string(), reason));
  };
  if (name.empty() || name == "." || name == "..") refuse("this would be another folder");
  for (const char* taken : {"index.html", "exact.json", "tolerance.json", "extremes.json", "random.json"})
    if (name == taken) refuse("this is the name of a file there");
  if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }))
    refuse("this one has control characters");
  try {
    static_cast<void>(nlohmann::json(name).dump());
  } catch (const nlohmann::json::exception&) {
    refuse("this one is not UTF-8");
  }
  return name;
}

/// `a:step:b` or a list.
std::vector<double> sweep_values(const EntryReader& entries) {
  const std::string text = entries.text("Sweep", "Values");
  if (text.find(':') == std::string::npos) return entries.numbers("Sweep", "Values", any_number);
  double begin = 0, step = 0, end = 0;
  char colon1 = 0, colon2 = 0;
  std::istringstream stream(text);
  if (!(stream >> begin >> colon1 >> step >> colon2 >> end) || colon1 != ':' || colon2 != ':' || !(step > 0) ||
      end < begin || (end - begin) / step > 1e5 || !(stream >> std::ws).eof())
    entries.fail("Sweep", "Values", "a list like 0, 45, 90 or a range like 0:5:180 (first : step : last)");
  std::vector<double> values;
  for (int k = 0; begin + k * step <= end + 1e-9 * step; ++k) values.push_back(begin + k * step);
  return values;
}

struct SweptEntry {
  std::string section, name;
};

SweptEntry swept_entry(const EntryReader& entries) {
  const std::string text = entries.text("Sweep", "Entry");
  const auto slash = text.find('/');
  if (slash == std::string::npos) entries.fail("Sweep", "Entry", "SECTION / ENTRY, for example Motion / Phase");
  SweptEntry swept{trimmed(text.substr(0, slash)), trimmed(text.substr(slash + 1))};
  if (!is_entry(swept.section, swept.name) || swept.section == "Sweep")
    entries.fail("Sweep", "Entry", "SECTION / ENTRY of this file, for example Motion / Phase");
  return swept;
}

std::vector<Case> expand_sweep(const fs::path& file, dealii::ParameterHandler& handler, const EntryReader& entries) {
  const auto swept = swept_entry(entries);
  const std::string family = case_name(file);
  std::string slug = swept.name;
  std::transform(slug.begin(), slug.end(), slug.begin(),
                 [](unsigned char c) { return c == ' ' ? '-' : static_cast<char>(std::tolower(c)); });
  std::vector<Case> cases;
  for (const double value : sweep_values(entries)) {
    handler.enter_subsection(swept.section);
    handler.set(swept.name, fmt::format("{:.15g}", value));
    handler.leave_subsection();
    Case input = read_entries(EntryReader(handler, file.string()), Case::Fields::none);
    input.name = fmt::format("{}/{}-{:g}", family, slug, value);
    input.sweep = Case::Sweep{family, swept.section + " / " + swept.name, value};
    cases.push_back(std::move(input));
  }
  return cases;
}

}  // namespace

std::vector<Case> read_case_file(const fs::path& file) {
  dealii::ParameterHandler handler;
  declare_entries(handler);
  Parser(handler).parse(file, {});
  const EntryReader entries(handler, file.string());
  if (entries.given("Sweep", "Entry")) return expand_sweep(file, handler, entries);
  Case input = read_entries(entries, Case::Fields::extremes);
  input.name = case_name(file);
  return {input};
}

Case read_case_text(const std::string& text, const fs::path& name) {
  dealii::ParameterHandler handler;
  declare_entries(handler);
  parse_text(text, name, handler);
  Case input = read_entries(EntryReader(handler, name.string()), Case::Fields::none);
  input.name = name.filename().string();
  return input;
}

}  // namespace fretval
