#include "comparison/data/branches_file.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::branches_file_test {
namespace {

Case::Elastomer body_of(const std::string& text, double relaxed = 0, std::optional<bool> youngs = {}) {
  const ScratchFolder folder;
  const auto file = folder.write("branches.csv", text).string();
  Case::Elastomer elastomer;
  elastomer.relaxed_modulus = relaxed;
  take_prony_series(file, read_prony_series(file, 0.5, youngs), elastomer);
  return elastomer;
}

/// G = 1 MPa at rest, 2 MPa with 0.1 s, 1 MPa with 10 s.
void expect_the_body(const Case::Elastomer& body, const std::string& text) {
  EXPECT_NEAR(body.relaxed_modulus, 1e6, 1e-3) << text;
  ASSERT_EQ(body.branch_moduli.size(), 2U) << text;
  EXPECT_NEAR(body.branch_moduli[0], 2e6, 1e-3) << text;
  EXPECT_NEAR(body.branch_moduli[1], 1e6, 1e-3) << text;
  EXPECT_NEAR(body.branch_times[0], 0.1, 1e-15) << text;
  EXPECT_NEAR(body.branch_times[1], 10, 1e-12) << text;
}

TEST(BranchesFile, IsReadAsOtherProgramsWriteIt) {
  for (const std::string text :
       {"G0 = 4 MPa\ng_i,tau_i\n-,s\n0.5,0.1\n0.25,10\n",                            // ratios to the modulus at once
        "E0 [MPa];12\ntau [ms];alpha\n100;0,5\n10000;0,25\n",                        // of Young's, half of Europe
        "# E_0: 12 MPa\n0.5 0.1\n0.25 10\n",                                         // without names
        "i,tau_i,alpha_i,E_0,E_i\n-,s,-,MPa,MPa\n1,0.1,0.5,12,6\n2,10,0.25,12,3\n",  // as fits are exported
        "E_inf = 3 MPa\nE_i [MPa],tau_i [s]\n6,0.1\n3,10\n",                         // moduli and the relaxed one
        "E_0 = 12 MPa\nE_i [MPa],tau_i [s]\n6,0.1\n3,10\n",                          // and the one at once
        "G0 = 4e6 Pa\ng_i,k_i,tau_i\n0.5,0,0.1\n0.25,0,10\n"})
    expect_the_body(body_of(text), text);
  expect_the_body(body_of("g_i,tau_i\n-,s\n0.5,0.1\n0.25,10\n", 1e6), "the relaxed modulus of the case");
  expect_the_body(body_of("modulus [MPa];tau [s]\n6;0,1\n3;10\n", 1e6, true), "Young's by Table modulus");
}

TEST(BranchesFile, MayBeAnInputOfAbaqus) {
  const std::string series = "*VISCOELASTIC, TIME=PRONY\n 0.5, 0., 0.1\n 0.25, 0., 10.\n";
  expect_the_body(body_of("** rubber\n*Material, name=R\n*Elastic, moduli=INSTANTANEOUS\n 12.e6, 0.5\n" + series),
                  series);
  expect_the_body(body_of("*ELASTIC\n3e6, 0.5\n" + series + "*DENSITY\n1e-9\n"), series);
  expect_the_body(body_of(series, 1e6), series);
  expect_the_body(body_of("*VISCOELASTIC, TIME=PRONY\n0.5,,0.1\n0.25, ,10\n", 1e6), "a blank is 0");
  expect_parts(refusal([] { body_of("*VISCOELASTIC, TIME=PRONY\n0.5, 0.1, 0.1\n", 1e6); }),
               {"branches.csv, line 2", "k_1 = 0.1", "must be 0"});
  expect_parts(refusal([] { body_of("*VISCOELASTIC, FREQUENCY=TABULAR\n1,1,1,1,1\n", 1e6); }), {"TIME=PRONY"});
}

// G = E/(2 (1 + nu)) with the ratio of the file.
TEST(BranchesFile, OfAbaqusHasTheShearModulusOfItsPoissonRatio) {
  const auto body = body_of("*ELASTIC\n2.6e6, 0.3\n*VISCOELASTIC, TIME=PRONY\n 0.5, 0., 0.1\n 0.25, 0., 10.\n");
  EXPECT_NEAR(body.relaxed_modulus, 1e6, 1e-6);
  EXPECT_NEAR(body.branch_moduli.at(0), 2e6, 1e-6);
}

TEST(BranchesFile, TakesRatiosInPercent) {
  expect_the_body(body_of("G0 = 4 MPa\ng_i,tau_i\n%,s\n50,0.1\n25,10\n"), "percent");
  expect_parts(refusal([] { body_of("G0 = 4 MPa\ng_i,tau_i\n%,s\n150,0.1\n"); }), {"a ratio of 1.5"});
}

TEST(BranchesFile, IsRefusedByName) {
  for (const auto& [text, part] :
       {std::pair("g_i,tau_i\n0.5,0.1\n", "says neither the instantaneous nor the relaxed modulus"),
        {"G0 = 4 MPa\ng_i,tau_i\n0.5,0.1\n0.5,1\n", "add up to 1"},
        {"G0 = 4 MPa\ng_i,tau_i\n-0.5,0.1\n", "-0.5"},
        {"G0 = 4 MPa\ng_i,tau_i\n0.5,-1\n", "relaxation time"},
        {"G0 = 4 MPa\nmodulus,tau_i\n2e6,1\n", "has no unit"},
        {"G0 = 4 psi\ng_i,tau_i\n0.5,1\n", "psi"},
        {"G0 = 4 MPa\ng_i,k_i,tau_i\n0.5,0.2,1\n", "k_1 = 0.2"},
        {"G0 = 2 MPa\nG_i [MPa],tau_i [s]\n3,1\n", "nothing is left"}})
    expect_parts(refusal([&, text = text] { body_of(text); }), {"branches.csv", part});
  expect_parts(refusal([] { body_of("G0 = 4 MPa\ng_i,tau_i\n0.5,1\n", 1e6); }), {"more than once"});
}

std::string case_with(const std::string& entries) {
  const auto begin = valid_case.find("subsection Elastomer"), end = valid_case.find("end\n", begin);
  return valid_case.substr(0, begin) + "subsection Elastomer\n" + entries + "\n" + valid_case.substr(end);
}

TEST(BranchesFile, StandsInTheCase) {
  const ScratchFolder folder;
  folder.write("branches.csv", "E0 = 12 MPa\ng_i,tau_i\n0.5,0.1\n0.25,10\n");
  const auto text = case_with("set Rheology = prony\nset Branches = branches.csv");
  expect_the_body(read_case_file(folder.write("case.prm", text)).at(0).elastomer, text);
  expect_the_body(
      read_case(case_with("set Rheology = prony\nset Instantaneous shear modulus = 4 MPa\nset Branch ratios "
                          "= 0.5, 0.25\nset Branch times = 0.1, 10 s"))
          .elastomer,
      "ratios");
}

TEST(BranchesFile, AHardnessTellsTheModulusByGent) {
  // 0.0981 (56 + 7.62336 50) / (0.137505 (254 - 2.54 50)) MPa = 2.4559 MPa.
  const auto body = read_case(case_with("set Rheology = elastic\nset Shore A = 50")).elastomer;
  EXPECT_NEAR(3 * body.relaxed_modulus, 2.4559e6, 2e2);
  EXPECT_EQ(body.modulus_scatter, 0.2);
  expect_parts(refusal([] { read_case(case_with("set Rheology = elastic\nset Shore A = 99")); }), {"Shore A = 99"});
  expect_parts(refusal([] {
                 read_case(case_with("set Rheology = elastic\nset Shore A = 50\nset Relaxed shear modulus = 1e6"));
               }),
               {"Relaxed shear modulus = 1e6", "the hardness Shore A tells it"});
}

// Columns may be of E by their names and of G by the case: 12 MPa at once, of which a quarter is left.
TEST(BranchesFile, TakesAColumnOfTheModulusAtOnceForWhatTheCaseSays) {
  const std::string text = "i,tau_i,alpha_i,E_0\n-,s,-,MPa\n1,0.1,0.5,12\n2,10,0.25,12\n";
  EXPECT_NEAR(body_of(text, 0, false).relaxed_modulus, 3e6, 1e-3);
  EXPECT_NEAR(body_of(text, 0, true).relaxed_modulus, 1e6, 1e-3);
}

}  // namespace
}  // namespace fretval::branches_file_test
