#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

int exit_code_of_trade(const std::string& file, const ScratchFolder& folder) {
  const std::string out = (folder.path() / "out").string(), log = (folder.path() / "log").string();
  const int status =
      std::system((std::string(FRETVAL_PROGRAM) + " trade " + file + " -o " + out + " >" + log + " 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(TradeCommand, RefusesBadInputAndWritesNothing) {
  const ScratchFolder folder;
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto forces = folder.write(
      "forces.prm", replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 0.1"));
  for (const auto& file : {sweep, bad, forces, folder.path() / "nowhere.prm"})
    EXPECT_EQ(exit_code_of_trade(file.string(), folder), 2) << file;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace fretval
