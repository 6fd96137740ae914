#include "comparison/report/text/render.h"

#include <ctemplate/template.h>

#include <stdexcept>

#include "comparison/report/text/resources.h"

namespace fretval {
namespace {

constexpr auto strip = ctemplate::STRIP_BLANK_LINES;
constexpr std::string_view ending = ".html";

/// Every template escapes what it is filled with.
ctemplate::TemplateCache& templates() {
  static ctemplate::TemplateCache cache;
  static const bool loaded = [] {
    for (const auto& [name, text] : resources())
      if (name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
        if (!cache.StringToTemplateCache(name, "{{%AUTOESCAPE context=\"HTML\"}}" + std::string(text), strip))
          throw std::runtime_error("the template " + name + " of the report is wrong");
    return true;
  }();
  static_cast<void>(loaded);
  return cache;
}

void fill(ctemplate::TemplateDictionary& dictionary, const Filling& data);

void add(ctemplate::TemplateDictionary& dictionary, const std::string& name, const Filling& value) {
  if (value.is_object()) {
    const bool included = value.contains("template");
    auto* part = included ? dictionary.AddIncludeDictionary(name) : dictionary.AddSectionDictionary(name);
    if (included) part->SetFilename(value["template"].get<std::string>() + std::string(ending));
    fill(*part, value);
  } else if (value.is_array()) {
    for (const auto& item : value)
      item.is_string() ? dictionary.AddSectionDictionary(name)->SetValue("text", item.get<std::string>())
                       : add(dictionary, name, item);
  } else if (value.is_boolean()) {
    if (value.get<bool>()) dictionary.ShowSection(name);
  } else if (!value.is_null()) {
    const auto text = value.is_string() ? value.get<std::string>() : value.dump();
    dictionary.SetValue(name, text);
    if (!text.empty()) dictionary.ShowSection(name);
  }
}

void fill(ctemplate::TemplateDictionary& dictionary, const Filling& data) {
  for (const auto& [name, value] : data.items()) add(dictionary, name, value);
}

}  // namespace

std::string rendered(const Filling& section) {
  if (section.is_null()) return "";
  const auto name = section.at("template").get<std::string>() + std::string(ending);
  ctemplate::TemplateDictionary dictionary(name);
  fill(dictionary, section);
  std::string html;
  if (!templates().ExpandWithData(name, strip, &dictionary, nullptr, &html))
    throw std::runtime_error("the report could not be made from the template " + name);
  return html;
}

}  // namespace fretval
