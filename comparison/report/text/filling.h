#pragma once

#include <nlohmann/json.hpp>

namespace fretval {

/// What a template is filled with, by the names of its markers; the document of a page consists of such. A section of
/// the report is such an object, whose "template" is the file in templates/ without its ending; null: there is nothing
/// to show. Templates are those of mustache.js, filled in the page by templates/sections.js:
///
/// Text stands, escaped, at {{name}}, and shows what is between {{#name}} and {{/name}} unless it is empty; true does
/// that, too. Objects fill {{#name}}...{{/name}}, an array of them as often as there are; with a "template" of their
/// own they stand at {{{name}}}. In an array of texts each is {{.}}.
using Filling = nlohmann::ordered_json;

}  // namespace fretval
