#pragma once

#include <array>
#include <string>
#include <string_view>

#include "comparison/report/text/filling.h"

namespace fretval {

/// templates/page.html with all that embed.js puts into it, around its title, its words and its document.
const std::array<std::string_view, 4>& page_pieces();

/// A page that shows a document, {"heading": a Filling, "sections": a list of them}, by its script; words: text for
/// readers without scripts. No text becomes HTML.
std::string page_of(const std::string& title, const std::string& words, const Filling& document);

}  // namespace fretval
