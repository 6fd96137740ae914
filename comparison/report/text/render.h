#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fretval {

/// What a template is filled with, by the names of its markers. A section of the report is such an object, whose
/// "template" is the file in templates/ without its ending; null: there is nothing to show.
///
/// Text stands at {{name}}, and shows what is between {{#name}} and {{/name}} unless it is empty; true does that, too.
/// Objects fill {{#name}}...{{/name}}, an array of them as often as there are; with a "template" of their own they
/// stand at {{>name}}. In an array of texts each is {{text}}.
using Filling = nlohmann::ordered_json;

/// The HTML of a section. Text is escaped for where it stands; {{name:none}} takes it for HTML. Throws
/// std::runtime_error for a template that is not there or is wrong.
std::string rendered(const Filling& section);

}  // namespace fretval
