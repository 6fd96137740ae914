#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "comparison/case/case.h"
#include "comparison/report/report.h"
#include "comparison/support/versions.h"
#include "tests/comparison/scratch_folder.h"

// The report without the libraries whose versions it names.
std::vector<std::pair<std::string, std::string>> fretval::versions() {
  return {{"fretval", "0"}};
}

/// A report is written from a stored result, or the result is refused as bad input. Nothing of the result gets into the
/// page as a tag.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fretval::ScratchFolder folder;
  folder.write("result.json", std::string(reinterpret_cast<const char*>(data), size));
  try {
    std::ifstream stream(fretval::write_report(folder.path()));
    std::stringstream page;
    page << stream.rdbuf();
    if (page.str().find("<script") != std::string::npos) std::abort();
  } catch (const fretval::InputError&) {
  }
  return 0;
}
