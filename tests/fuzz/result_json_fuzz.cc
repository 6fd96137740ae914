#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "comparison/case/case.h"
#include "comparison/report/report.h"
#include "comparison/report/text/page.h"
#include "tests/comparison/scratch_folder.h"

namespace {

std::size_t n_scripts(std::string_view text) {
  constexpr std::string_view tag = "<script";
  std::size_t n = 0;
  for (auto at = text.find(tag); at != std::string_view::npos; at = text.find(tag, at + tag.size())) ++n;
  return n;
}

/// Those of every page: its data, what shows and what draws it.
std::size_t n_own_scripts() {
  std::size_t n = 0;
  for (const auto piece : fretval::page_pieces()) n += n_scripts(piece);
  return n;
}

}  // namespace

/// A report is written from a stored result, or the result is refused as bad input. Nothing of the result gets into the
/// page as a tag: it has no more scripts than every page has.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fretval::ScratchFolder folder;
  static const std::size_t n_own = n_own_scripts();
  folder.write("result.json", std::string(reinterpret_cast<const char*>(data), size));
  try {
    std::ifstream stream(fretval::write_report(folder.path()));
    std::stringstream page;
    page << stream.rdbuf();
    if (n_scripts(page.str()) != n_own) std::abort();
  } catch (const fretval::InputError&) {
  }
  return 0;
}
