#include "comparison/case_file/case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "comparison/case_file/case_sections.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/case_file/file_entries.h"

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

/// A file, and those that it includes, whose entries its own override.
struct ParsedFile {
  explicit ParsedFile(fs::path file_) : file(std::move(file_)) { parse(file, {}); }
  [[nodiscard]] EntryReader reader() { return {entries, file.string(), problems}; }

  fs::path file;
  EntryTexts entries;
  Problems problems;

 private:
  /// chain: the files that include this one.
  void parse(const fs::path& part, std::vector<fs::path> chain) {
    const fs::path canonical = fs::weakly_canonical(part);
    if (std::find(chain.begin(), chain.end(), canonical) != chain.end())
      throw InputError(fmt::format("{}: the file includes itself", part.string()));
    chain.push_back(canonical);
    if (++n_parts_ > most_includes)
      throw InputError(fmt::format("{}: more than {} files are included", chain.front().string(), most_includes));
    if (part.extension() == ".json") return parse_json_entries(read_text(part), part, entries, problems);
    const auto prm = read_prm(read_text(part), part, problems);
    for (const auto& included : prm.included) parse(included, chain);
    entries.override_by(prm.entries);
  }

  std::size_t n_parts_ = 0;
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

EntryPlace swept_entry(const EntryReader& entries, const char* name_of_entry) {
  auto swept = place_of(entries.text("Sweep", name_of_entry));
  if (!is_entry(swept.section, swept.entry) || swept.section == "Sweep")
    entries.fail("Sweep", name_of_entry, "SECTION / ENTRY of this file, for example Motion / Phase");
  entries.throw_problems();
  return swept;
}

constexpr double most_values = 1e5;  // of a sweep, each of which is a case

/// `a : step : b` or a list, in the units of the swept entry.
std::vector<double> sweep_values(const EntryReader& entries, const EntryPlace& swept, const char* name_of_values) {
  const std::string text = entries.text("Sweep", name_of_values);
  const bool is_range = text.find(':') != std::string::npos;
  const auto list = entries.numbers_for(swept.section, swept.entry, text, is_range ? ':' : ',');
  const bool rises = list.size() == 3 && list[1] > 0 && list[2] >= list[0];
  const double n_values = !is_range ? static_cast<double>(list.size())
                          : rises   ? std::floor((list[2] - list[0]) / list[1] + 1e-9) + 1
                                    : 0;
  if (n_values > most_values)
    entries.fail("Sweep", name_of_values,
                 fmt::format("at most {:.0f} values of {} / {}, and these are {:.0f}", most_values, swept.section,
                             swept.entry, n_values));
  else if (n_values == 0)
    entries.fail("Sweep", name_of_values,
                 fmt::format("a list like 0, 45, 90 or a range like 0:5:180 (first : step : last), {}",
                             entries.units_of(swept.section, swept.entry)));
  entries.throw_problems();
  if (!is_range) return list;
  const double begin = list[0], step = list[1], end = list[2];
  std::vector<double> values;
  for (int k = 0; begin + k * step <= end + 1e-9 * step; ++k) values.push_back(begin + k * step);
  return values;
}

struct SweptValues {
  EntryPlace swept;
  std::vector<double> values;
};

/// The swept entries of a file: one of a line, two of a map.
std::vector<SweptValues> swept_values(const EntryReader& entries) {
  std::vector<SweptValues> all;
  const auto first = swept_entry(entries, "Entry");
  all.push_back({first, sweep_values(entries, first, "Values")});
  if (!entries.given("Sweep", "Second entry")) return all;
  const auto second = swept_entry(entries, "Second entry");
  if (first.section == second.section && first.entry == second.entry)
    entries.fail("Sweep", "Second entry", "another one than the Entry");
  entries.throw_problems();
  all.push_back({second, sweep_values(entries, second, "Second values")});
  if (const auto n = all[0].values.size() * all[1].values.size(); static_cast<double>(n) > most_values)
    entries.fail("Sweep", "Second values",
                 fmt::format("at most {:.0f} cases altogether, and these are {}", most_values, n));
  entries.throw_problems();
  return all;
}

/// Part of the name of a point of a sweep, "tangential-amplitude-1e-05".
std::string slug_of(const EntryPlace& swept, double value) {
  std::string slug = swept.entry;
  std::transform(slug.begin(), slug.end(), slug.begin(),
                 [](unsigned char c) { return c == ' ' ? '-' : static_cast<char>(std::tolower(c)); });
  return fmt::format("{}-{:g}", slug, value);
}

/// The case with each of the values in the place of the swept entry, of a map with each of both.
std::vector<Case> cases_at(const std::vector<SweptValues>& all, ParsedFile parsed, Accuracy accuracy) {
  const auto family = case_name(parsed.file);
  const auto full_name = [](const EntryPlace& swept) { return swept.section + " / " + swept.entry; };
  const auto set = [&](const EntryPlace& swept, double value) {
    parsed.entries.set(swept.section, swept.entry, fmt::format("{:.15g}", value));
  };
  const bool is_map = all.size() > 1;
  std::vector<Case> cases;
  for (const double value : all[0].values)
    for (const double second : is_map ? all[1].values : std::vector<double>{0}) {
      set(all[0].swept, value);
      if (is_map) set(all[1].swept, second);
      Case input = read_entries(parsed.reader(), accuracy);
      input.name = fmt::format("{}/{}", family, slug_of(all[0].swept, value));
      input.sweep = Case::Sweep{family, full_name(all[0].swept), value};
      if (is_map) {
        input.name += "-" + slug_of(all[1].swept, second);
        input.sweep->second_entry = full_name(all[1].swept);
        input.sweep->second_value = second;
      }
      cases.push_back(std::move(input));
    }
  return cases;
}

std::vector<double> in_equal_parts(std::vector<double> values, std::size_t n) {
  std::sort(values.begin(), values.end());
  std::vector<double> fine;
  const std::size_t parts = values.size() < 2 ? 0 : 1 + (n - 1) / (values.size() - 1);
  for (std::size_t k = 0; k + 1 < values.size(); ++k)
    for (std::size_t part = 0; part < parts; ++part)
      fine.push_back(values[k] + (values[k + 1] - values[k]) * static_cast<double>(part) / static_cast<double>(parts));
  if (parts > 0) fine.push_back(values.back());
  return fine;
}

}  // namespace

std::vector<Case> read_case_file(const fs::path& file, Accuracy accuracy) {
  ParsedFile parsed(file);
  const auto entries = parsed.reader();
  if (entries.given("Sweep", "Entry")) return cases_at(swept_values(entries), parsed, accuracy);
  Case input = read_entries(entries, accuracy);
  input.name = case_name(file);
  return {input};
}

std::vector<Case> cases_between(const fs::path& file, std::size_t n) {
  ParsedFile parsed(file);
  const auto entries = parsed.reader();
  if (!entries.given("Sweep", "Entry")) return {};
  auto all = swept_values(entries);
  for (auto& one : all) one.values = in_equal_parts(one.values, n);
  try {
    return cases_at(all, parsed, Accuracy::optional);
  } catch (const InputError&) {
    return {};
  }
}

Case read_case_text(const std::string& text, const fs::path& name) {
  Problems problems;
  const auto prm = read_prm(text, name, problems);
  Case input = read_entries({prm.entries, name.string(), problems}, Accuracy::needed);
  input.name = name.filename().string();
  return input;
}

}  // namespace fretval
