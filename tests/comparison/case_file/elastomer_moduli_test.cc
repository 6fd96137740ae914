#include <gtest/gtest.h>

#include <utility>

#include "comparison/case_file/case_sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::elastomer_moduli_test {
namespace {

Case::Elastomer elastomer(const std::string& entries) {
  const auto begin = valid_case.find("subsection Elastomer"), end = valid_case.find("end\n", begin);
  return read_case(valid_case.substr(0, begin) + "subsection Elastomer\n" + entries + "\n" + valid_case.substr(end))
      .elastomer;
}

TEST(ElastomerModuli, OfRatiosFollowFromEitherModulus) {
  for (const char* modulus : {"set Instantaneous shear modulus = 4 MPa", "set Relaxed shear modulus = 1 MPa"}) {
    const auto body = elastomer(
        std::string("set Rheology = prony\nset Branch ratios = 0.5, 0.25\nset Branch times = 0.1, 10 s\n") + modulus);
    EXPECT_NEAR(body.relaxed_modulus, 1e6, 1e-3) << modulus;
    ASSERT_EQ(body.branch_moduli.size(), 2U) << modulus;
    EXPECT_NEAR(body.branch_moduli[0], 2e6, 1e-3) << modulus;
    EXPECT_NEAR(body.branch_moduli[1], 1e6, 1e-3) << modulus;
  }
}

// Young's modulus of an incompressible body is three times its shear modulus, at nu = 1/4 two and a half times.
TEST(ElastomerModuli, OfAFileAreThoseThatTheCaseSays) {
  const ScratchFolder folder;
  const auto file = folder.write("branches.csv", "modulus [MPa],tau [s]\n7.5,0.1\n").string();
  const auto branch = [&](const std::string& entries) {
    return elastomer("set Rheology = prony\nset Branches = " + file + "\nset Relaxed shear modulus = 1 MPa\n" + entries)
        .branch_moduli.at(0);
  };
  EXPECT_NEAR(branch("set Table modulus = shear"), 7.5e6, 1e-3);
  EXPECT_NEAR(branch("set Table modulus = Young"), 2.5e6, 1e-3);
  EXPECT_NEAR(branch("set Table modulus = Young\nset Poisson ratio = 0.25"), 3e6, 1e-3);
}

TEST(ElastomerModuli, ThatContradictEachOtherAreRefused) {
  for (const auto& [entries, part] :
       {std::pair("set Branch ratios = 0.5, 0.5\nset Branch times = 1, 2\nset Relaxed shear modulus = 1e6",
                  "a sum below 1"),
        {"set Branch ratios = 0.5, 0.6\nset Branch times = 1, 2\nset Relaxed shear modulus = 1e6",
         "ratios to the instantaneous modulus of a sum below 1"},
        {"set Branch ratios = 0.5\nset Branch times = 1, 2\nset Relaxed shear modulus = 1e6", "1 times"},
        {"set Branch ratios = 0.5\nset Branch times = 1\nset Branch moduli = 1e6\nset Relaxed shear modulus = 1e6",
         "stand in their place"},
        {"set Branch ratios = 0.5\nset Branch times = 1\nset Relaxed shear modulus = 1e6\nset Instantaneous shear "
         "modulus = 2e6",
         "has no meaning here"},
        {"set Branch ratios = 0.5\nset Branch times = 1", "neither the instantaneous nor the relaxed modulus"}})
    expect_parts(refusal([&, entries = entries] { elastomer(std::string("set Rheology = prony\n") + entries); }),
                 {part});
}

}  // namespace
}  // namespace fretval::elastomer_moduli_test
