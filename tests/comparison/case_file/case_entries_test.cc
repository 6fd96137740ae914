#include <gtest/gtest.h>

#include <utility>

#include "comparison/case_file/case_sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::case_entries_test {
namespace {

std::string case_with(const std::string& section, const std::string& entries) {
  return valid_case + "subsection " + section + "\n" + entries + "\nend\n";
}

std::string refusal_of(const std::string& section, const std::string& entries) {
  return refusal([&] { read_case(case_with(section, entries)); });
}

TEST(CaseEntries, HaveNoDefaultsButOfTheOnlyLaw) {
  EXPECT_EQ(read_case(replace(valid_case, "  set Law = unidirectional\n", "")).friction_coefficient, 0.5);
  for (const auto& [line, entry] : {std::pair("  set Coefficient = 0.5\n", "Friction / Coefficient"),
                                    {"  set Tolerance = 0.01\n", "Accuracy / Tolerance"}})
    expect_parts(refusal([&, line = line] { read_case(replace(valid_case, line, "")); }),
                 {"case.prm: " + std::string(entry) + " is missing"});
}

TEST(CaseEntries, OfALimitingProfileAreAStickRadiusAndNoWear) {
  const std::string limiting = "set State = limiting\nset Stick radius ratio = ";
  const Case input = read_case(case_with("Wear", limiting + "0.5"));
  EXPECT_EQ(input.wear, Case::Wear::limiting);
  EXPECT_EQ(input.worn_stick_ratio, 0.5);
  EXPECT_FALSE(input.wear_kinetics);
  for (const double ratio : {0.01, 0.99})
    EXPECT_EQ(read_case(case_with("Wear", limiting + std::to_string(ratio))).worn_stick_ratio, ratio);
  for (const char* ratio : {"0.009", "0.991", "1"})
    expect_parts(refusal_of("Wear", limiting + ratio), {"Stick radius ratio = ", "0.01 to 0.99"});
  expect_parts(refusal_of("Wear", limiting + "0.5\nset Cycles = 10"), {"Wear / Cycles = 10", "wears no more"});
  expect_parts(refusal_of("Wear", "set Stick radius ratio = 0.5"), {"it belongs to State = limiting"});
  const std::string forced =
      replace(case_with("Wear", limiting + "0.5"), "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 0.1");
  expect_parts(refusal([&] { read_case(forced); }), {"Stick radius ratio = 0.5", "follows from the motion"});
}

TEST(CaseEntries, OfWearAreALawAndWhereItEnds) {
  const auto wear = [](const std::string& entries) { return read_case(case_with("Wear", entries)).wear_kinetics; };
  const auto archard = wear("set Coefficient = 1e-12");
  EXPECT_EQ(archard->law, Case::WearLaw::archard);
  EXPECT_EQ(archard->exponent, 1);
  EXPECT_FALSE(archard->n_cycles);
  EXPECT_EQ(archard->until, 0);
  EXPECT_EQ(wear("set Law = energy\nset Coefficient = 1e-12\nset Until = 1e-3")->until, 1e-3);
  const auto power = wear("set Law = power\nset Exponent = 0.5\nset Coefficient = 1e-12");
  EXPECT_EQ(power->law, Case::WearLaw::power);
  EXPECT_EQ(power->exponent, 0.5);
  expect_parts(refusal_of("Wear", "set Law = linear\nset Coefficient = 1"),
               {"Wear / Law = linear", "archard", "power"});
  expect_parts(refusal_of("Wear", "set Law = power\nset Coefficient = 1"), {"Wear / Exponent is missing"});
  expect_parts(refusal_of("Wear", "set Coefficient = 1\nset Exponent = 2"), {"it belongs to Law = power"});
  for (const char* exponent : {"0.2", "4.1"})
    expect_parts(refusal_of("Wear", std::string("set Law = power\nset Coefficient = 1\nset Exponent = ") + exponent),
                 {"0.25 to 4"});
  for (const char* until : {"1", "0"})
    expect_parts(refusal_of("Wear", std::string("set Coefficient = 1\nset Until = ") + until), {"1e-12 to 1"});
}

TEST(CaseEntries, OfWearKineticsComeTogether) {
  EXPECT_FALSE(read_case().wear_kinetics);
  const Case input = read_case(case_with("Wear", "set Coefficient = 2e-12\nset Cycles = 300"));
  EXPECT_EQ(input.wear_kinetics->coefficient, 2e-12);
  EXPECT_EQ(input.wear_kinetics->n_cycles, 300);
  expect_parts(refusal_of("Wear", "set Cycles = 300"), {"Wear / Coefficient is missing"});
}

TEST(CaseEntries, OfTheResolutionAreWholeNumbersWithinBounds) {
  EXPECT_FALSE(read_case().rings_per_radius);
  EXPECT_FALSE(read_case().steps_per_cycle);
  const Case input = read_case(case_with("Accuracy", "set Rings per radius = 640\nset Steps per cycle = 16"));
  EXPECT_EQ(input.rings_per_radius, 640U);
  EXPECT_EQ(input.steps_per_cycle, 16);
  const Case other = read_case(case_with("Accuracy", "set Rings per radius = 16\nset Steps per cycle = 10000"));
  EXPECT_EQ(other.rings_per_radius, 16U);
  EXPECT_EQ(other.steps_per_cycle, 10000);
  for (const char* rings : {"15", "641", "20.5"})
    expect_parts(refusal_of("Accuracy", std::string("set Rings per radius = ") + rings), {"from 16 to 640"});
  for (const char* steps : {"15", "10001", "20.5"})
    expect_parts(refusal_of("Accuracy", std::string("set Steps per cycle = ") + steps), {"from 16 to 10000"});
}

TEST(CaseEntries, OfTheToleranceIncludeTheirBounds) {
  const auto tolerance = [](const std::string& text) {
    return read_case(replace(valid_case, "Tolerance = 0.01", "Tolerance = " + text)).tolerance;
  };
  EXPECT_EQ(tolerance("1e-5"), 1e-5);
  EXPECT_EQ(tolerance("0.1"), 0.1);
  for (const char* text : {"9e-6", "0.11"})
    expect_parts(refusal([&] { tolerance(text); }), {"Accuracy / Tolerance = ", "between 1e-5 and 0.1"});
}

TEST(CaseEntries, HaveAToleranceOfACycleWhereItIsSet) {
  const auto with = [](const std::string& text) {
    return read_case(
        replace(valid_case, "set Tolerance = 0.01", "set Tolerance = 0.01\n  set Cycle tolerance = " + text));
  };
  EXPECT_FALSE(read_case(valid_case).cycle_tolerance);
  EXPECT_EQ(with("1e-3").cycle_tolerance, 1e-3);
  expect_parts(refusal([&] { with("0.2"); }), {"Accuracy / Cycle tolerance = ", "between 1e-5 and 0.1"});
}

Case read(const std::string& entries,
          const std::string& loops = "F_x [mN];u_x [um];F_N [N]\n1,5;2;0,5\n-1,5;-2;0,4\n") {
  const ScratchFolder folder;
  folder.write("loops.csv", loops);
  return read_case_file(folder.write("case.prm", valid_case + "subsection Measured\n" + entries + "end\n")).at(0);
}

TEST(Measured, HasRadiiAndLoops) {
  const auto measured =
      read("set Loops = loops.csv\nset Stick radius = 0.8 mm\nset Stick radius uncertainty = 20 um\n").measured;
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->stick_radius->value, 0.8e-3, 1e-15);
  EXPECT_NEAR(measured->stick_radius->uncertainty, 20e-6, 1e-15);
  EXPECT_FALSE(measured->contact_radius);
  ASSERT_EQ(measured->tangential_force.size(), 2U);
  EXPECT_NEAR(measured->tangential_force[0], 1.5e-3, 1e-15);
  EXPECT_NEAR(measured->tangential_displacement[1], -2e-6, 1e-18);
  EXPECT_EQ(measured->normal_force[1], 0.4);
  EXPECT_TRUE(measured->time.empty() && measured->indentation.empty());
  EXPECT_FALSE(read_case().measured);
}

TEST(Measured, IsRefusedByName) {
  expect_parts(refusal([] { read("set Stick radius = 1 mm\n"); }), {"Measured / Stick radius uncertainty is missing"});
  expect_parts(refusal([] { read("set Stick radius uncertainty = 1 um\n"); }), {"it belongs to a Stick radius"});
  expect_parts(refusal([] { read("set Loops = other.csv\n"); }), {"Loops = other.csv", "the name of a file"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "t [s],d [um]\n0,1\n"); }), {"neither a column F_N nor"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "F_x [N],q [V]\n0,1\n"); }), {"loops.csv"});
  expect_parts(refusal([] { read("set Loops = loops.csv\n", "F_x,u_x\n0,1\n"); }), {"no unit"});
}

}  // namespace
}  // namespace fretval::case_entries_test
