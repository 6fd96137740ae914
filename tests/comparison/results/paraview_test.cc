#include <gtest/gtest.h>

#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::paraview_test {
namespace {

namespace fs = std::filesystem;

const fs::path sources = FRETVAL_SOURCE_DIR;

/// The fields of a case, as they are written for 24 instants.
class ParaViewSlow : public testing::Test {
 protected:
  void SetUp() override {
    const auto file = folder_.write("case.prm", valid_case + "subsection Output\n  set Fields = cycle\nend\n");
    const auto run =
        fretval_run("-q run --proof none " + quoted(file) + " -o " + quoted(folder_.path() / "out"), folder_);
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  /// A script, by the Python that Debian's packages belong to.
  [[nodiscard]] fretval::Run script(const std::string& command) const {
    return shell_run("/usr/bin/python3 " + command, folder_);
  }

  [[nodiscard]] fretval::Run checked(int n_instants) const {
    return script(quoted(sources / "tests/comparison/results/paraview.py") + " " + quoted(result_) + " " +
                  std::to_string(n_instants));
  }

  ScratchFolder folder_;
  const fs::path result_ = folder_.path() / "out/case";
};

TEST_F(ParaViewSlow, ReadsForcesAndStressesThatAreThoseOfTheResult) {
  const auto run = checked(24);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

TEST_F(ParaViewSlow, TheCheckSeesAnInstantThatIsAnother) {
  fs::copy_file(result_ / "fields/surface-05.vtu", result_ / "fields/surface-11.vtu",
                fs::copy_options::overwrite_existing);
  fs::copy_file(result_ / "fields/section-05.vtu", result_ / "fields/section-17.vtu",
                fs::copy_options::overwrite_existing);
  const auto run = checked(25);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  for (const char* problem : {"fields.pvd has 24 steps, expected 25", "surface-11.vtu: normal force",
                              "surface-11.vtu: tangential force", "section-17.vtu: depth of the centre"})
    EXPECT_NE(run.out.find(problem), std::string::npos) << problem << "\nin\n" << run.out;
}

// Both legends, the section and the surface: at least as many colours as their scales have.
TEST_F(ParaViewSlow, DrawsThem) {
  const auto picture = folder_.path() / "picture.png";
  const auto draw = shell_run("xvfb-run -a /usr/bin/python3 " + quoted(sources / "docs/example/fields.py") + " " +
                                  quoted(result_) + " " + quoted(picture) + " -1 320",
                              folder_);
  ASSERT_EQ(draw.exit_code, 0) << draw.out << draw.err;
  const auto count = script(
      "-c 'import sys; from vtkmodules.vtkIOImage import vtkPNGReader as R; r = R(); r.SetFileName(sys.argv[1]); "
      "r.Update(); s = r.GetOutput().GetPointData().GetScalars(); "
      "print(r.GetOutput().GetDimensions()[:2], len({s.GetTuple(i) for i in range(s.GetNumberOfTuples())}))' " +
      quoted(picture));
  ASSERT_EQ(count.out.rfind("(320, 200) ", 0), 0U) << count.out << count.err;
  EXPECT_GT(std::stoi(count.out.substr(count.out.find(')') + 1)), 500);
}

}  // namespace
}  // namespace fretval::paraview_test
