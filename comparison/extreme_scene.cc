#include "comparison/extreme_scene.h"

#include <fmt/format.h>

#include "comparison/case_file.h"
#include "comparison/mdr_scene.h"
#include "mdr/profile.h"
#include "mdr/shakedown_amplitude.h"

namespace fretval {
namespace {

std::string text_of(const Entries& entries) {
  std::string text;
  for (const auto& [place, value] : entries) {
    const auto slash = place.find(" / ");
    text += fmt::format("subsection {}\n  set {} = {}\nend\n", place.substr(0, slash), place.substr(slash + 3), value);
  }
  return text;
}

}  // namespace

std::string entry_text(double value) {
  return fmt::format("{}", value);
}

Entries extremes_base() {
  return {{"Indenter / Shape", "parabola"},
          {"Indenter / Radius", "1e-2"},
          {"Elastomer / Rheology", "standard solid"},
          {"Elastomer / Relaxed shear modulus", "1e6"},
          {"Elastomer / Branch moduli", "1e6"},
          {"Elastomer / Branch times", "0.1"},
          {"Friction / Coefficient", "0.5"},
          {"Friction / Law", "unidirectional"},
          {"Motion / Indentation", "1e-4"},
          {"Motion / Normal amplitude", "2e-5"},
          {"Motion / Normal frequency", "1"},
          {"Motion / Tangential amplitude", "1.5e-5"},
          {"Motion / Tangential frequency", "1"},
          {"Motion / Phase", "60"},
          {"Accuracy / Tolerance", "1e-2"}};
}

Entries with(Entries entries, const Entries& changes) {
  for (const auto& [place, value] : changes) entries[place] = value;
  return entries;
}

Entries with_stick_ratio(const Entries& entries, double stick_ratio, double factor) {
  const auto scene = case_of(entries, "scene");
  const auto mdr = mdr_scene(scene);
  const double contact_radius = mdr::inverse_transform(mdr.profile, mdr::maximum_indentation(mdr.motion));
  const auto amplitude = mdr::tangential_amplitude_for_shakedown(
      mdr.body, mdr.friction_coefficient, mdr.motion, mdr::transform(mdr.profile, stick_ratio * contact_radius));
  if (!amplitude) throw InputError(fmt::format("no tangential amplitude shakes down at c/a = {:g}", stick_ratio));
  return with(entries, {{"Motion / Tangential amplitude", entry_text(factor * *amplitude)}});
}

Case case_of(const Entries& entries, const std::string& name) {
  Case scene = read_case_text(text_of(entries), "suite extremes");
  scene.name = name;
  return scene;
}

std::string extremes_table(const std::string& file) {
  return std::string(FRETVAL_EXTREMES_CASES) + "/" + file;
}

}  // namespace fretval
