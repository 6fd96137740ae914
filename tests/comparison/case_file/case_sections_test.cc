#include "comparison/case_file/case_sections.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::case_sections_test {
namespace {

/// The valid case with other lines instead of those of a section.
std::string case_with(const std::string& section, const std::string& entries) {
  const auto begin = valid_case.find("subsection " + section), end = valid_case.find("end\n", begin);
  return valid_case.substr(0, begin) + "subsection " + section + "\n" + entries + "\n" + valid_case.substr(end);
}

Case::Indenter indenter(const std::string& entries) {
  return read_case(case_with("Indenter", entries)).indenter;
}

Case::Elastomer elastomer(const std::string& entries) {
  return read_case(case_with("Elastomer", entries)).elastomer;
}

Case::Motion motion(const std::string& entries) {
  return read_case(case_with("Motion", entries)).motion;
}

TEST(CaseSections, EveryShapeHasItsOwnNumbers) {
  const auto cone = indenter("set Shape = cone\nset Slope angle = 5");
  EXPECT_EQ(cone.shape, Case::Shape::cone);
  EXPECT_EQ(cone.slope_angle, 5);
  const auto power = indenter("set Shape = power\nset Coefficient = 3\nset Exponent = 2.5");
  EXPECT_EQ(power.shape, Case::Shape::power);
  EXPECT_EQ(power.coefficient, 3);
  EXPECT_EQ(power.exponent, 2.5);
  const auto arc = indenter("set Shape = sphere\nset Radius = 3e-3");
  EXPECT_EQ(arc.shape, Case::Shape::sphere);
  EXPECT_EQ(arc.radius, 3e-3);
  const auto flat = indenter("set Shape = rounded flat\nset Flat radius = 1e-3\nset Edge radius = 2e-3");
  EXPECT_EQ(flat.shape, Case::Shape::rounded_flat);
  EXPECT_EQ(flat.flat_radius, 1e-3);
  EXPECT_EQ(flat.edge_radius, 2e-3);
  const auto sphere = indenter("set Shape = truncated sphere\nset Radius = 1e-2\nset Flat radius = 1e-3");
  EXPECT_EQ(sphere.shape, Case::Shape::truncated_sphere);
  EXPECT_EQ(sphere.radius, 1e-2);
  EXPECT_EQ(sphere.flat_radius, 1e-3);
}

/// Of the section Motion.
constexpr const char* pressed =
    "set Indentation = 1e-4\nset Normal amplitude = 0\nset Normal frequency = 1\nset Tangential frequency = 2\nset "
    "Phase = 0\n";

/// What is said of it beside friction as a vector.
Case::Motion motion_across(const std::string& entries) {
  return read_case(case_with("Motion", pressed + entries) + "subsection Contact\n  set Friction = vector\nend\n")
      .motion;
}

TEST(CaseSections, ForcesGoAcrossForcesAndDisplacementsAcrossDisplacements) {
  const auto moved = motion_across(
      "set Tangential amplitude = 1e-5\nset Transverse amplitude = 2e-5\nset Transverse "
      "phase = 90\nset Transverse harmonics = 1e-6, 4, 0");
  ASSERT_EQ(moved.transverse.size(), 2U);
  EXPECT_EQ(moved.transverse[0].amplitude, 2e-5);
  EXPECT_EQ(moved.transverse[0].frequency, 2);
  EXPECT_EQ(moved.transverse[0].phase, 90);
  const auto pushed = motion_across(
      "set Tangential force amplitude = 0.1\nset Transverse force amplitude = 0.2\nset "
      "Transverse phase = 90\nset Transverse frequency = 4\nset Transverse force "
      "harmonics = 0.01, 8, 0");
  ASSERT_EQ(pushed.transverse.size(), 2U);
  EXPECT_EQ(pushed.transverse[0].amplitude, 0.2);
  EXPECT_EQ(pushed.transverse[0].frequency, 4);
  EXPECT_EQ(pushed.transverse[1].amplitude, 0.01);
  const auto refused = [](const std::string& entries) { return refusal([&] { motion_across(entries); }); };
  expect_parts(
      refused("set Tangential force amplitude = 0.1\nset Transverse amplitude = 2e-5\nset Transverse phase = 0"),
      {"Motion / Transverse amplitude", "a Transverse force amplitude"});
  expect_parts(refused("set Tangential amplitude = 1e-5\nset Transverse force amplitude = 2\nset Transverse phase = 0"),
               {"Motion / Transverse force amplitude", "belongs to a Tangential force amplitude"});
  expect_parts(refused("set Tangential force amplitude = 0.1\nset Transverse phase = 0"),
               {"Motion / Transverse phase", "belongs to a Transverse force amplitude"});
}

TEST(CaseSections, BoundsAreTakenOrRefusedAsTheMessageSays) {
  for (const double exponent : {0.5, 20.0})
    EXPECT_EQ(indenter("set Shape = power\nset Coefficient = 3\nset Exponent = " + std::to_string(exponent)).exponent,
              exponent);
  for (const char* exponent : {"0.49", "20.1"})
    expect_parts(
        refusal([&] { indenter(std::string("set Shape = power\nset Coefficient = 3\nset Exponent = ") + exponent); }),
        {std::string("Exponent = ") + exponent, "a number between 0.5 and 20"});
  for (const char* angle : {"0", "90"})
    expect_parts(refusal([&] { indenter(std::string("set Shape = cone\nset Slope angle = ") + angle); }),
                 {std::string("Slope angle = ") + angle, "between 0 and 90 degrees"});
  const std::string fractional =
      "set Rheology = fractional zener\nset Relaxed shear modulus = 1e6\nset Branch moduli = 2e6\n"
      "set Branch times = 1\nset Fractional order = ";
  EXPECT_EQ(elastomer(fractional + "1").fractional_order, 1);
  for (const char* order : {"0", "1.01"})
    expect_parts(refusal([&] { elastomer(fractional + order); }),
                 {std::string("Fractional order = ") + order, "above 0 and at most 1"});
}

TEST(CaseSections, NumbersOfAnotherShapeOrBodyAreRefused) {
  expect_parts(refusal([] { indenter("set Shape = cone\nset Slope angle = 5\nset Radius = 1"); }),
               {"Indenter / Radius = 1", "it belongs to Shape = parabola or sphere or truncated sphere, not to cone"});
  expect_parts(refusal([] { elastomer("set Rheology = elastic\nset Relaxed shear modulus = 1\nset Viscosity = 1"); }),
               {"Elastomer / Viscosity = 1", "kelvin voigt or prony, not to elastic"});
}

TEST(CaseSections, EveryRheologyHasItsOwnNumbers) {
  const auto voigt = elastomer("set Rheology = kelvin voigt\nset Relaxed shear modulus = 1e6\nset Viscosity = 2e4");
  EXPECT_EQ(voigt.viscosity, 2e4);
  EXPECT_TRUE(voigt.branch_moduli.empty());
  const std::string branches =
      "set Relaxed shear modulus = 1e6\nset Branch moduli = 2e6, 3e6\nset Branch times = 1, 4\n";
  const auto prony = elastomer("set Rheology = prony\n" + branches);
  EXPECT_EQ(prony.relaxed_modulus, 1e6);
  EXPECT_EQ(prony.branch_moduli, (std::vector<double>{2e6, 3e6}));
  EXPECT_EQ(prony.branch_times, (std::vector<double>{1, 4}));
  EXPECT_EQ(prony.viscosity, 0);
  expect_parts(refusal([&] { elastomer("set Rheology = standard solid\n" + branches); }),
               {"Branch moduli = 2e6, 3e6", "Rheology = prony"});
}

// Measured at T_r, asked for where times are ten times as long: the curve moves to a tenth of its frequencies.
TEST(CaseSections, TemperatureShiftsWhatWasMeasured) {
  const ScratchFolder folder;
  const auto table = folder.write("dma.csv", standard_solid_table()).string();
  const auto cold =
      elastomer("set Rheology = table\nset Table modulus = shear\nset Table = " + table +
                "\nset Temperature = -5\nset Reference temperature = 20\nset WLF C1 = 1\nset WLF C2 = 50");
  EXPECT_NEAR(cold.master_curve->frequency.front() / 1e-5, 1, 1e-9);
  EXPECT_NEAR(cold.master_curve->frequency.back() / 1e3, 1, 1e-9);
}

// Half the way to the pole at T_r - c2: log10 a_T = c1, so times and viscosity are ten times as long; moduli stay.
TEST(CaseSections, TemperatureShiftsTimesAndViscosity) {
  const std::string body =
      "set Rheology = prony\nset Relaxed shear modulus = 1e6\nset Branch moduli = 2e6\nset Branch times = 0.5\n"
      "set Viscosity = 30\n";
  const auto cold =
      elastomer(body + "set Temperature = -5\nset Reference temperature = 20\nset WLF C1 = 1\nset WLF C2 = 50");
  EXPECT_NEAR(cold.branch_times[0], 5, 1e-14);
  EXPECT_NEAR(cold.viscosity, 300, 1e-12);
  EXPECT_EQ(cold.branch_moduli[0], 2e6);
  EXPECT_EQ(cold.relaxed_modulus, 1e6);
  expect_parts(
      refusal([&] {
        elastomer(body + "set Temperature = -30\nset Reference temperature = 20\nset WLF C1 = 1\nset WLF C2 = 50");
      }),
      {"case.prm: Elastomer / Temperature: "});
  expect_parts(refusal([&] { elastomer(body + "set WLF C1 = 1"); }), {"WLF C1 = 1", "it belongs to a Temperature"});
}

const std::string frequencies = "set Normal frequency = 1\nset Tangential frequency = 2\nset Phase = free\n";
const std::string displacements = "set Indentation = 1e-4\nset Normal amplitude = 2e-5\n";

TEST(CaseSections, ForcesStandInsteadOfDisplacements) {
  const auto forced = motion(frequencies + "set Normal force = 3\nset Normal force amplitude = 1\n" +
                             "set Tangential force amplitude = 0.5");
  EXPECT_EQ(forced.normal_force->mean, 3);
  EXPECT_EQ(forced.normal_force->amplitude, 1);
  EXPECT_EQ(forced.tangential_force, 0.5);
  EXPECT_EQ(forced.normal_frequency, 1);
  EXPECT_EQ(forced.tangential_frequency, 2);
  EXPECT_FALSE(forced.phase);
  expect_parts(
      refusal([] {
        motion(frequencies + displacements + "set Tangential force amplitude = 1\nset Tangential amplitude = 1e-5");
      }),
      {"Tangential amplitude = 1e-5", "Tangential force amplitude is prescribed"});
  expect_parts(
      refusal([] {
        motion(frequencies + displacements + "set Tangential amplitude = 1e-5\nset Normal force amplitude = 1");
      }),
      {"Normal force amplitude = 1", "it belongs to a Normal force"});
}

TEST(CaseSections, AMotionInTwoDirectionsRepeats) {
  const auto moves = [](const std::string& tangential, const std::string& transverse) {
    const auto entries = displacements + "set Normal frequency = 0.3\nset Tangential frequency = " + tangential +
                         "\nset Phase = 0\nset Tangential amplitude = 1e-5\nset Transverse amplitude = 1e-5\n" +
                         "set Transverse phase = 90\nset Transverse frequency = " + transverse;
    return read_case(case_with("Motion", entries) + "subsection Contact\n  set Friction = vector\nend\n").motion;
  };
  EXPECT_EQ(moves("0.9", "0.4").transverse[0].frequency, 0.4);
  expect_parts(refusal([&] { moves("0.900001", "0.3"); }),
               {"Tangential frequency = 0.900001", "that repeats", "instead of 0.3, 0.900001, 0.3 Hz"});
  expect_parts(refusal([&] { moves("0.9", "0.424264068711929"); }), {"that repeats"});
  expect_parts(refusal([&] { moves("0.9", "-1"); }), {"Transverse frequency = -1"});
}

TEST(CaseSections, HarmonicsOfAmplitudeZeroAreNone) {
  const auto read = motion(frequencies + displacements + "set Normal harmonics = 0, 400, 10, 1e-6, 3, 20\n" +
                           "set Tangential amplitude = 1e-5\nset Tangential harmonics = 0, 7, 0");
  ASSERT_EQ(read.normal_harmonics.size(), 1U);
  EXPECT_EQ(read.normal_harmonics[0].frequency, 3);
  EXPECT_TRUE(read.tangential_harmonics.empty());
}

TEST(CaseSections, HarmonicsBelongToWhatIsPrescribed) {
  const std::string rest = "set Normal frequency = 1\n  set Tangential frequency = 1\n  set Phase = 0\n";
  const std::string by_force = "set Normal force = 1\n  set Normal force amplitude = 0.1\n",
                    shifted = "set Tangential amplitude = 1e-6\n";
  const auto read = motion(rest + by_force + "set Normal force harmonics = 20 mN, 2 Hz, 30 deg\n" +
                           "set Tangential force amplitude = 0.1\nset Tangential force harmonics = 0.01, 3, 0");
  ASSERT_EQ(read.normal_harmonics.size(), 1U);
  EXPECT_NEAR(read.normal_harmonics[0].amplitude, 0.02, 1e-15);
  ASSERT_EQ(read.tangential_harmonics.size(), 1U);
  EXPECT_EQ(read.tangential_harmonics[0].frequency, 3);
  expect_parts(refusal([&] { motion(rest + by_force + shifted + "set Normal harmonics = 1e-6, 2, 0"); }),
               {"Motion / Normal harmonics", "the Normal force is prescribed"});
  expect_parts(refusal([&] { motion(rest + by_force + shifted + "set Tangential force harmonics = 0.1, 2, 0"); }),
               {"Motion / Tangential force harmonics", "it belongs to a Tangential force amplitude"});
  expect_parts(refusal([&] { motion(rest + by_force + shifted + "set Normal force harmonics = 0.1, 2"); }),
               {"Motion / Normal force harmonics", "amplitude in N"});
}

TEST(CaseSections, HarmonicsAreTriples) {
  const std::string still = frequencies + displacements + "set Tangential amplitude = 0\n";
  const auto read = motion(still + "set Normal harmonics = 1e-6, 3, 45, 2e-6, 5, -90");
  ASSERT_EQ(read.normal_harmonics.size(), 2U);
  EXPECT_TRUE(read.tangential_harmonics.empty());
  EXPECT_EQ(read.normal_harmonics[1].amplitude, 2e-6);
  EXPECT_EQ(read.normal_harmonics[1].frequency, 5);
  EXPECT_EQ(read.normal_harmonics[1].phase, -90);
  for (const std::string direction : {"Normal", "Tangential"})
    for (const char* bad : {"1e-6, 3", "-1e-6, 3, 45", "1e-6, 0, 45"})
      expect_parts(refusal([&] { motion(still + "set " + direction + " harmonics = " + bad); }),
                   {"Motion / " + direction + " harmonics = ", "triples of amplitude", "not negative", "positive"});
}

std::string with_contact(const std::string& entries, const std::string& text = valid_case) {
  return text + "\nsubsection Contact\n" + entries + "\nend\n";
}

TEST(CaseSections, TheContactOnRingsAndAnglesIsAskedFor) {
  EXPECT_FALSE(read_case(valid_case).contact.is_full());
  EXPECT_FALSE(read_case(with_contact("set Friction = unidirectional\nset Coupling = off")).contact.is_full());
  const auto vector = read_case(with_contact("set Friction = vector")).contact;
  EXPECT_TRUE(vector.vector_friction);
  EXPECT_FALSE(vector.coupled);
  EXPECT_TRUE(read_case(with_contact("set Friction = vector\nset Coupling = on")).contact.coupled);
  EXPECT_TRUE(read_case(with_contact("set Friction = vector\nset Second algorithm = on")).contact.second_algorithm);
  expect_parts(refusal([] { read_case(with_contact("set Second algorithm = on")); }),
               {"Contact / Second algorithm", "Friction = vector"});
  expect_parts(refusal([] { read_case(with_contact("set Coupling = on")); }),
               {"Contact / Coupling", "Friction = vector"});
  expect_parts(refusal([] { read_case(with_contact("set Friction = both")); }),
               {"Contact / Friction = both", "vector"});
}

// An eighth of the tolerance of the case, 0.05, goes to a record: 0.00625 of its largest indentation, 110 um.
TEST(CaseSections, ARecordIsReducedToAnEighthOfTheToleranceOfTheCase) {
  std::string rows = "t [ms],d [um],u_x [um]\n";
  for (int i = 0; i <= 3000; ++i)
    rows += fmt::format("{},{:.9f},{:.9f}\n", i, 100 + 10 * std::cos(2 * M_PI * i / 3000),
                        5 * std::cos(2 * M_PI * i / 3000));
  const ScratchFolder folder;
  const auto file = folder.write("path.csv", rows);
  const auto path = motion("set Path = " + file.string() + "\nset Path repeats = forever").path;
  ASSERT_TRUE(path && path->reduction);
  EXPECT_LE(path->reduction->normal_error, 0.00625 * 110e-6);
  EXPECT_LE(path->reduction->tangential_error, 0.00625 * 5e-6);
}

}  // namespace
}  // namespace fretval::case_sections_test
