#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace fretval {

/// Writes DIR/index.html, one self-contained page about every result.json below DIR (the verdict, the figures of the
/// paper with MDR as lines and finite elements as points, the differences, and the cost), every trade.json, and the
/// JSON of the suites in DIR; whatever is there. Returns the file. Throws InputError if nothing is there or something
/// cannot be read. of_this_run: names of the cases of the present run, so that the page can tell which results are
/// older; empty: not known.
std::filesystem::path write_report(const std::filesystem::path& folder, const std::set<std::string>& of_this_run = {});

}  // namespace fretval
