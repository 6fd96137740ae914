
#include <cmath>
#include <map>

#include "comparison/report/drawing/figures.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/results/case_inputs.h"
#include "comparison/support/constants.h"
#include "mdr/layer/layer.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t few_scenes = 2;

/// Numbers stay on a line with their units.
std::string unbroken(const std::string& text) {
  std::string kept;
  for (const char letter : text)
    if (letter == ' ' && !kept.empty() && kept.back() >= '0' && kept.back() <= '9')
      kept += "\u00a0";
    else
      kept += letter;
  return kept;
}

/// omega tau of each branch.
std::string branches_text(const ordered_json& scene, double angular_frequency) {
  std::string text;
  for (const auto& input : scene.value("inputs", ordered_json::array()))
    if (input.at("name").get<std::string>().rfind("Branch times", 0) == 0)
      for (const auto& time : input.at("value"))
        text += (text.empty() ? "" : ", ") + number_text(angular_frequency * time.get<double>(), "{:.3g}");
  return text;
}

/// Numbers of the template `scene`; a group that the case does not have is not shown.
void add_groups(const StoredResult& r, Filling& filling) {
  const auto& scene = r.json.at("scene");
  const double a = r.number("scene", "contact_radius_unworn");
  const auto add = [&](const char* key, double value, const char* format) {
    if (std::isfinite(value)) filling[key] = number_text(value, format);
  };
  const bool oscillates = !scene.contains("path");
  if (oscillates) {
    const double nu = input_number(r, "Poisson ratio", "Elastomer");
    add("k",
        mdr::spring_modulus_ratio(std::isnan(nu) ? 0.5 : nu) * r.number("scene", "friction_coefficient") *
            r.number("scene", "normal_amplitude") / r.number("scene", "tangential_amplitude"),
        "{:.4g}");
    add("rho", r.number("mdr", "modulus_ratio"), "{:.5g}");
    filling["omega_tau"] = branches_text(scene, 2 * pi * r.number("scene", "frequency"));
  }
  add("a_over_r", a / input_number(r, "Radius", "Indenter"), "{:.3g}");
  const auto mesh = scene.find("mesh");
  add("a_over_h",
      a / (mesh == scene.end() ? input_number(r, "Thickness", "Body") : mesh->at("thickness").get<double>()), "{:.3g}");
  add("a_over_b", a / input_number(r, "Radius", "Body"), "{:.3g}");
  add("first_slip", r.number("fe", "stick_radius_first_slip") / a, "{:.4f}");
  add("shakedown", r.number("fe", "stick_radius_shakedown") / a, "{:.4f}");
  for (const char* group : {"k", "rho", "a_over_r", "a_over_h", "a_over_b", "first_slip", "shakedown"})
    if (filling.contains(group)) filling["has_groups"] = true;
}

}  // namespace

Filling inputs_of(const ordered_json& scene) {
  auto sections = ordered_json::array();
  for (const auto& input : scene.value("inputs", ordered_json::array())) {
    if (sections.empty() || sections.back().at("section") != input.at("section"))
      sections.push_back({{"section", input.at("section")}, {"entries", ordered_json::array()}});
    sections.back()["entries"].push_back(
        {{"name", input.at("name")},
         {"value", unbroken(input_text(input.at("value"), input.at("unit").get<std::string>(), 6))}});
  }
  return sections;
}

Filling scene_of(const StoredResult& r) {
  Filling filling{{"template", "scene"}, {"inputs", inputs_of(r.json.at("scene"))}};
  if (auto sketch = sketch_of(r); !sketch.is_null()) filling["sketch"] = std::move(sketch);
  add_groups(r, filling);
  return filling;
}

Filling scenes_section(const std::vector<StoredResult>& results) {
  std::map<std::string, std::pair<const StoredResult*, std::size_t>> firsts;  // with how many there are of its family
  for (const auto& r : results)
    if (!r.sweep().empty()) {
      auto& [first, n] = firsts[r.family()];
      if (!first) first = &r;
      ++n;
    }
  if (firsts.empty()) return nullptr;
  auto scenes = Filling::array();
  for (const auto& [family, counted_first] : firsts) {
    const auto& [first, n] = counted_first;
    scenes.push_back({{"family", family},
                      {"cases", counted(n, "case")},
                      {"entry", first->entry()},
                      {"open", firsts.size() <= few_scenes},
                      {"long", firsts.size() > few_scenes},
                      {"scene", scene_of(*first)},
                      {"assumptions", assumptions_of(*first)}});
  }
  return {{"template", "scenes"},
          {"one", firsts.size() == 1},
          {"several", firsts.size() > 1},
          {"n", firsts.size()},
          {"scenes", std::move(scenes)}};
}

}  // namespace fretval
