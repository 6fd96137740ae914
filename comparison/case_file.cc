#include "comparison/case_file.h"

#include <deal.II/base/parameter_handler.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "comparison/case_entries.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(fmt::format("{}: no such file", file.string()));
  if (!fs::is_regular_file(file, error)) throw InputError(fmt::format("{}: not a file", file.string()));
  std::ifstream stream(file);
  std::stringstream text;
  if (!(text << stream.rdbuf())) throw InputError(fmt::format("{}: empty or not readable", file.string()));
  return text.str();
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

struct Includes {
  std::vector<fs::path> files;
  std::string text;  // the including file with its include lines blanked, so that line numbers stay right
};

Includes split_includes(const fs::path& file) {
  Includes result;
  std::istringstream text(read_text(file));
  std::string line;
  while (std::getline(text, line)) {
    std::istringstream words(line);
    std::string word, name;
    words >> word;
    if (word == "include") {
      words >> name;
      if (name.empty()) throw InputError(fmt::format("{}: an include line names no file", file.string()));
      result.files.push_back(file.parent_path() / name);
      if (!fs::exists(result.files.back()))
        throw InputError(
            fmt::format("{}: include {}: no such file as {}", file.string(), name, result.files.back().string()));
      line.clear();
    }
    result.text += line + '\n';
  }
  return result;
}

/// Runs what parses a file; its errors become bad input.
template <class Parse>
void parse_as_input(const fs::path& file, const Parse& parse) {
  try {
    parse();
  } catch (const dealii::ExceptionBase& error) {
    throw InputError(fmt::format("{}: {}. Valid entries: {}", file.string(), first_sentence(error), valid_entries()));
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void parse(const fs::path& file, dealii::ParameterHandler& handler, std::vector<fs::path> chain) {
  const fs::path canonical = fs::weakly_canonical(file);
  if (std::find(chain.begin(), chain.end(), canonical) != chain.end())
    throw InputError(fmt::format("{}: the file includes itself", file.string()));
  chain.push_back(canonical);
  parse_as_input(file, [&] {
    if (file.extension() == ".json") {
      std::istringstream text(read_text(file));
      handler.parse_input_from_json(text);
      return;
    }
    const auto split = split_includes(file);
    for (const auto& included : split.files) parse(included, handler, chain);
    std::istringstream text(split.text);
    handler.parse_input(text, file.string());
  });
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
  for (int k = 0; begin + k * step <= end * (1 + 1e-12); ++k) values.push_back(begin + k * step);
  return values;
}

struct SweptEntry {
  std::string section, name;
};

SweptEntry swept_entry(const EntryReader& entries) {
  const std::string text = entries.text("Sweep", "Entry");
  const auto slash = text.find('/');
  if (slash == std::string::npos) entries.fail("Sweep", "Entry", "SECTION / ENTRY, for example Motion / Phase");
  const auto trim = [](std::string word) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    return word;
  };
  SweptEntry swept{trim(text.substr(0, slash)), trim(text.substr(slash + 1))};
  if (!is_entry(swept.section, swept.name) || swept.section == "Sweep")
    entries.fail("Sweep", "Entry", "SECTION / ENTRY of this file, for example Motion / Phase");
  return swept;
}

std::vector<Case> expand_sweep(const fs::path& file, dealii::ParameterHandler& handler, const EntryReader& entries) {
  const auto swept = swept_entry(entries);
  const std::string family = file.stem().string();
  std::string slug = swept.name;
  std::transform(slug.begin(), slug.end(), slug.begin(),
                 [](unsigned char c) { return c == ' ' ? '-' : static_cast<char>(std::tolower(c)); });
  std::vector<Case> cases;
  for (const double value : sweep_values(entries)) {
    handler.enter_subsection(swept.section);
    handler.set(swept.name, fmt::format("{:.15g}", value));
    handler.leave_subsection();
    Case scene = read_entries(EntryReader(handler, file.string()), Case::Fields::none);
    scene.name = fmt::format("{}/{}-{:g}", family, slug, value);
    scene.sweep = Case::Sweep{family, swept.section + " / " + swept.name, value};
    cases.push_back(std::move(scene));
  }
  return cases;
}

}  // namespace

std::vector<Case> read_case_file(const fs::path& file) {
  dealii::ParameterHandler handler;
  declare_entries(handler);
  parse(file, handler, {});
  const EntryReader entries(handler, file.string());
  if (entries.given("Sweep", "Entry")) return expand_sweep(file, handler, entries);
  Case scene = read_entries(entries, Case::Fields::extremes);
  scene.name = file.stem().string();
  return {scene};
}

Case read_case_text(const std::string& text, const fs::path& name) {
  dealii::ParameterHandler handler;
  declare_entries(handler);
  parse_as_input(name, [&] {
    std::istringstream stream(text);
    handler.parse_input(stream, name.string());
  });
  Case scene = read_entries(EntryReader(handler, name.string()), Case::Fields::none);
  scene.name = name.filename().string();
  return scene;
}

}  // namespace fretval
