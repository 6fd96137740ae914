#include <cstddef>
#include <cstdint>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/simulation/fem_case/fem_case.h"
#include "tests/comparison/scratch_folder.h"

/// No stack traces in the exceptions of deal.II: they take a hundred times longer than reading the case.
extern "C" int backtrace(void** /*buffer*/, int /*size*/) {
  return 0;
}

namespace {

/// A folder with the files that the seeds name: tables, and a case to include.
const fretval::ScratchFolder& scratch() {
  static const fretval::ScratchFolder folder;
  static const bool filled = [] {
    folder.write("base.inc", fretval::valid_case);
    folder.write("profile.csv", "r,f\nmm,um\n0,0\n1,1\n2,4\n3,9\n4,16\n5,25\n6,36\n");
    folder.write("moduli.csv", "f,G',G''\nHz,Pa,Pa\n0.1,1e6,1e5\n1,1.1e6,2e5\n10,1.5e6,4e5\n100,1.9e6,3e5\n");
    return true;
  }();
  static_cast<void>(filled);
  return folder;
}

}  // namespace

/// A case file is read and made dimensionless, or refused as bad input; text that begins with { is read as JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto file = scratch().write(!text.empty() && text[0] == '{' ? "case.json" : "case.prm", text);
  try {
    const auto cases = fretval::read_case_file(file);
    const auto mdr = fretval::mdr_case(cases.front());
    static_cast<void>(
        fretval::fem_case(cases.front(), fretval::expected_contact(mdr), fretval::limiting_indenter(mdr)));
  } catch (const fretval::InputError&) {
  } catch (const std::invalid_argument&) {  // prepare() puts the name of the file before it
  }
  return 0;
}
