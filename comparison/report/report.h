#pragma once

#include <filesystem>

namespace fretval {

/// Writes DIR/index.html, one self-contained page about every result.json below DIR (the verdict, the figures of the
/// paper with MDR as lines and finite elements as points, the differences, and the cost), every trade.json, and the
/// JSON of the suites in DIR; whatever is there. Returns the file. Throws InputError if nothing is there or something
/// cannot be read, std::runtime_error if gnuplot fails.
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace fretval
