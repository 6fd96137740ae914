#include <gtest/gtest.h>

#include <filesystem>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(TradeCommand, RefusesBadInputAndWritesNothing) {
  const ScratchFolder folder;
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto forces = folder.write(
      "forces.prm", replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 0.1"));
  const auto out = folder.path() / "out";
  for (const auto& file : {sweep, bad, forces, folder.path() / "nowhere.prm"})
    EXPECT_EQ(fretval_run("trade " + file.string() + " -o " + out.string(), folder).exit_code, 2) << file;
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace fretval
