#include "comparison/results/case_inputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace fretval {
namespace {

TEST(CaseInputs, ListWhatTheCaseHasWithItsUnit) {
  Case input{};
  input.indenter.radius = 0.01;
  input.elastomer.branch_times = {0.1, 2};
  input.motion.normal_amplitude = 2e-5;
  std::map<std::string, nlohmann::ordered_json> found;
  for (const auto& one : inputs_json(input)) found[one.at("name")] = one;
  EXPECT_EQ(found.at("Radius"),
            nlohmann::ordered_json::parse(R"({"section": "Indenter", "name": "Radius", "value": 0.01, "unit": "m"})"));
  EXPECT_EQ(found.at("Branch times").at("value"), nlohmann::ordered_json({0.1, 2.0}));
  EXPECT_EQ(found.at("Normal amplitude").at("unit"), "m");
  EXPECT_EQ(found.at("Phase").at("value"), "free");
  for (const char* absent : {"Slope angle", "Table", "Viscosity", "Branch moduli", "Normal force", "Law"})
    EXPECT_EQ(found.count(absent), 0U) << absent;
}

TEST(CaseInputs, AreWrittenForPeople) {
  EXPECT_EQ(input_text(1e-4, "m", 6), "100 µm");
  EXPECT_EQ(input_text({2e6, 5e5}, "Pa", 6), "2 MPa, 500 kPa");
  EXPECT_EQ(input_text(2000, "m^-1", 6), "2000 m^-1") << "of a power: a prefix would count with it";
  EXPECT_EQ(input_text(60, "°", 6), "60°");
  EXPECT_EQ(input_text("parabola", "", 6), "parabola");
  EXPECT_EQ(input_text(0.123456789, "", 6), "0.123457");
  EXPECT_EQ(input_text(0.123456789, "", 10), "0.123456789");
}

std::map<std::string, nlohmann::ordered_json> values_of(const Case& input) {
  std::map<std::string, nlohmann::ordered_json> found;
  for (const auto& one : inputs_json(input)) found[one.at("name")] = one.at("value");
  return found;
}

std::string unit_of(const Case& input, const char* section, const char* name) {
  for (const auto& one : inputs_json(input))
    if (one.at("section") == section && one.at("name") == name) return one.at("unit");
  return "not there";
}

// What somebody has set to nothing is an input, too.
TEST(CaseInputs, HaveTheZerosOfAMotion) {
  Case input{};
  input.motion.phase = 0;
  const auto found = values_of(input);
  for (const char* name : {"Phase", "Normal amplitude", "Tangential amplitude"}) EXPECT_EQ(found.at(name), 0.0) << name;
}

// A compressible body of Poisson's ratio 0 has one; an incompressible one is that of a case which says nothing.
TEST(CaseInputs, HaveAZeroThatIsNotWhatACaseBeginsWith) {
  Case input{};
  EXPECT_EQ(values_of(input).count("Poisson ratio"), 0U);
  input.elastomer.poisson_ratio = 0;
  EXPECT_EQ(values_of(input).at("Poisson ratio"), 0.0);
}

TEST(CaseInputs, HaveTheContactOnRingsAndAnglesAndItsOtherDirection) {
  Case input{};
  EXPECT_EQ(values_of(input).count("Friction"), 0U);
  input.contact = {true, true};
  input.motion.transverse = {{3e-5, 1, 90}};
  const auto found = values_of(input);
  EXPECT_EQ(found.at("Friction"), "vector");
  EXPECT_EQ(found.at("Coupling"), "on");
  EXPECT_EQ(found.at("Transverse harmonics"), nlohmann::ordered_json({"30 µm at 1 Hz, phase 90°"}));
}

TEST(CaseInputs, HaveHarmonicsInWords) {
  Case input{};
  input.motion.normal_harmonics = {{5e-6, 2, 0}, {1.5e-3, 3, -90}};
  const auto found = values_of(input);
  EXPECT_EQ(found.at("Normal harmonics"),
            nlohmann::ordered_json({"5 µm at 2 Hz, phase 0°", "1.5 mm at 3 Hz, phase -90°"}));
  EXPECT_EQ(found.count("Tangential harmonics"), 0U);
  input.motion.normal_force = Case::NormalForce{0.5, 0.1};
  input.motion.normal_harmonics = {{0.02, 2, 30}};
  EXPECT_EQ(values_of(input).at("Normal force harmonics"), nlohmann::ordered_json({"20 mN at 2 Hz, phase 30°"}));
}

TEST(CaseInputs, SayWhatWasMeasuredAtWhichTemperature) {
  Case input{};
  input.indenter.table_noise = 1e-7;
  input.elastomer.rheology = Case::Rheology::table;
  input.elastomer.master_curve = Case::MasterCurve{};
  input.elastomer.master_curve->table = "dma.csv";
  input.elastomer.master_curve->youngs = true;
  input.elastomer.branch_times = {0.5};
  input.elastomer.shift = Case::TemperatureShift{40, 20, 17.4, 51.6};
  const auto found = values_of(input);
  EXPECT_EQ(found.at("Table noise"), 1e-7);
  EXPECT_EQ(found.at("Table"), "dma.csv");
  EXPECT_EQ(found.at("Table modulus"), "Young");
  EXPECT_EQ(found.at("Branch times, fitted at the Temperature"), nlohmann::ordered_json({0.5}));
  EXPECT_EQ(found.at("Temperature"), 40.0);
  EXPECT_EQ(found.at("Reference temperature"), 20.0);
  EXPECT_EQ(found.at("WLF C1"), 17.4);
  EXPECT_EQ(found.at("WLF C2"), 51.6);
  EXPECT_EQ(unit_of(input, "Elastomer", "Temperature"), "degC");
  EXPECT_EQ(unit_of(input, "Elastomer", "WLF C2"), "K");
}

TEST(CaseInputs, HaveTheWearWithTheUnitOfItsLaw) {
  Case input{};
  input.wear = Case::Wear::limiting;
  input.worn_stick_ratio = 0.5;
  input.wear_kinetics = Case::WearKinetics{Case::WearLaw::power, 1e-12, 1.5, std::nullopt, 0.25, "worn.csv"};
  auto found = values_of(input);
  EXPECT_EQ(found.at("State"), "limiting");
  EXPECT_EQ(found.at("Stick radius ratio"), 0.5);
  EXPECT_EQ(found.at("Law"), "power");
  EXPECT_EQ(unit_of(input, "Wear", "Exponent"), "");
  EXPECT_EQ(found.at("Cycles"), "until nothing wears any more");
  EXPECT_EQ(found.at("Until"), 0.25);
  EXPECT_EQ(found.at("Profile"), "worn.csv");
  EXPECT_EQ(unit_of(input, "Wear", "Coefficient"), "Pa^-1.5");
  input.wear_kinetics = Case::WearKinetics{Case::WearLaw::archard, 0, 1, 100, 0};
  found = values_of(input);
  EXPECT_EQ(found.at("Cycles"), 100.0);
  EXPECT_EQ(found.count("Until"), 0U);
  EXPECT_EQ(unit_of(input, "Wear", "Coefficient"), "1/Pa");
}

TEST(CaseInputs, HaveRingsAndStepsThatAreFixed) {
  Case input{};
  input.rings_per_radius = 48;
  input.steps_per_cycle = 96;
  const auto found = values_of(input);
  EXPECT_EQ(found.at("Rings per radius"), 48);
  EXPECT_EQ(found.at("Steps per cycle"), 96);
  EXPECT_EQ(values_of(Case{}).count("Rings per radius"), 0U);
}

TEST(CaseInputs, HaveForcesAndWhatWasMeasured) {
  Case input{};
  input.motion.normal_force = Case::NormalForce{0.5, 0.1};
  input.motion.tangential_force = 0.05;
  input.motion.normal_frequency = 2;
  input.motion.tangential_frequency = 3;
  input.measured = Case::Measured{};
  input.measured->stick_radius = {0.8e-3, 2e-5};
  input.measured->contact_radius = {1.1e-3, 1e-5};
  input.measured->loop = "loops.csv";
  const auto found = values_of(input);
  for (const auto& [name, value] : std::map<std::string, double>{{"Normal force", 0.5},
                                                                 {"Normal force amplitude", 0.1},
                                                                 {"Tangential force amplitude", 0.05},
                                                                 {"Normal frequency", 2},
                                                                 {"Tangential frequency", 3},
                                                                 {"Stick radius", 0.8e-3},
                                                                 {"Stick radius uncertainty", 2e-5},
                                                                 {"Contact radius", 1.1e-3},
                                                                 {"Contact radius uncertainty", 1e-5}})
    EXPECT_EQ(found.at(name), value) << name;
  EXPECT_EQ(found.at("Loops"), "loops.csv");
  EXPECT_EQ(found.count("Indentation"), 0U);
}

/// Section, name, value and unit of each.
std::string listed(const Case& input) {
  std::string text;
  for (const auto& one : inputs_json(input))
    text += one.at("section").get<std::string>() + " / " + one.at("name").get<std::string>() + " = " +
            one.at("value").dump() + " " + one.at("unit").get<std::string>() + "\n";
  return text;
}

void expect_listed(const Case& input, const std::vector<std::string>& lines) {
  for (const auto& line : lines) EXPECT_NE(listed(input).find(line + "\n"), std::string::npos) << line;
}

// Each entry that is one of several words, with the word that a new case does not have, beside the one that it has.
TEST(CaseInputs, HaveTheOtherWordsToo) {
  Case input{};
  input.motion.phase = 30;
  input.contact = {true, false};
  input.body = {Case::Body::Shape::layer, 2e-3, 0, false};
  expect_listed(input, {"Motion / Phase = 30.0 °", "Contact / Coupling = \"off\" ", "Body / Base = \"frictionless\" ",
                        "Body / Thickness = 0.002 m"});
  EXPECT_EQ(listed(input).find("Second algorithm"), std::string::npos);
  EXPECT_EQ(listed(input).find("Mesh unit"), std::string::npos);
  EXPECT_EQ(listed(input).find("Cycle tolerance"), std::string::npos);
  input.contact.second_algorithm = true;
  input.body.is_bonded = true;
  input.tolerance = 1e-2;
  input.cycle_tolerance = 3e-3;
  expect_listed(input, {"Contact / Second algorithm = \"on\" ", "Body / Base = \"bonded\" ",
                        "Accuracy / Tolerance = 0.01 ", "Accuracy / Cycle tolerance = 0.003 "});
  input.motion.path = Case::Path{{{0, 1}, {1e-4, 1e-4}, {0, 1e-5}, false}, "rig.csv"};
  expect_listed(input, {"Motion / Path = \"rig.csv\" ", "Motion / Path repeats = \"once\" "});
  input.motion.path->repeats = true;
  expect_listed(input, {"Motion / Path repeats = \"forever\" "});
}

// A power law of exponent 3 has a coefficient in m^-2; the hardness, the alignment and the test are inputs as well.
TEST(CaseInputs, HaveWhatDataWereTakenAs) {
  Case input{};
  input.indenter.shape = Case::Shape::power;
  input.indenter.coefficient = 4e4;
  input.indenter.exponent = 3;
  input.elastomer.shore_a = 40;
  input.elastomer.relaxed_modulus = 5e5;
  input.elastomer.test_duration = Case::TestDuration{3600, 2e5, {}, {}, 0};
  input.wear_kinetics = Case::WearKinetics{Case::WearLaw::archard, 1e-12, 1, {}, 0, "", "worn_rings.csv"};
  input.body.mesh_unit = 1;
  expect_listed(input, {"Indenter / Coefficient = 40000.0 m^-2", "Elastomer / Shore A = 40.0 ",
                        "Elastomer / Duration of the test = 3600.0 s",
                        "Elastomer / Relaxed shear modulus = 500000.0 Pa", "Wear / Worn rings = \"worn_rings.csv\" "});
  EXPECT_EQ(listed(input).find("Table alignment"), std::string::npos);
  EXPECT_EQ(listed(input).find("Profile"), std::string::npos);
  input.indenter.trace = Case::AlignedTrace{};
  expect_listed(input, {"Indenter / Table alignment = \"fit\" "});
  EXPECT_EQ(listed(Case{}).find("Shore A"), std::string::npos);
}

// Of an absent value there is a dash, and of temperatures and of nothing no prefix.
TEST(CaseInputs, AreWrittenWithoutPrefixesWhereThereIsNone) {
  EXPECT_EQ(input_text(nullptr, "m", 6), "–");
  EXPECT_EQ(input_text(0, "m", 6), "0 m");
  EXPECT_EQ(input_text(25, "degC", 6), "25 °C");
}

TEST(CaseInputs, NameTheAmplitudeThatFollows) {
  Case input{};
  input.motion.tangential_amplitude = std::nan("");
  const auto found = values_of(input);
  EXPECT_EQ(found.at("Tangential amplitude"), "shakedown");
}

}  // namespace
}  // namespace fretval
