#include "comparison/case_file/entry_reader.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

/// What a case says whose phase is written so.
std::string refusal_of_phase(const std::string& text) {
  return refusal([&] { read_case(replace(valid_case, "Phase = 60", "Phase = " + text)); });
}

TEST(EntryReader, TakesNothingForANumberThatIsOnlyPartlyOne) {
  EXPECT_EQ(read_case(replace(valid_case, "Phase = 60", "Phase = -1.5e-3")).motion.phase, -1.5e-3);
  for (const char* text : {"1 m", "1,5", "0x10", "1e", "--1", "inf", "1e999"})
    expect_parts(refusal_of_phase(text), {"case.prm: Motion / Phase = ", text, "a finite number"});
  expect_parts(refusal_of_phase(""), {"case.prm: Motion / Phase is missing", "a finite number"});
}

TEST(EntryReader, SplitsListsAndHoldsEachValueToWhatIsValid) {
  const auto branches = [](const std::string& times) {
    const auto text = replace(valid_case, "moduli = 1e6\n  set Branch times = 0.1",
                              "moduli = 1e6, 1e6, 1e6\n  set Branch times = " + times);
    return read_case(replace(text, "standard solid", "prony")).elastomer.branch_times;
  };
  EXPECT_EQ(branches("1,2e-3 ,\t3"), (std::vector<double>{1, 2e-3, 3}));
  for (const char* times : {"1, -2, 3", "1,,3", "1, 2,", "1; 2; 3"})
    expect_parts(refusal([&] { branches(times); }), {"case.prm: Elastomer / Branch times = "});
}

TEST(EntryReader, TakesUnitsOfWhatTheEntryMeasures) {
  const auto with = [](const std::string& from, const std::string& to) {
    return read_case(replace(valid_case, from, from.substr(0, from.find('=') + 2) + to));
  };
  EXPECT_EQ(with("Radius = 1e-2", "10 mm").indenter.radius, 1e-2);
  EXPECT_EQ(with("Radius = 1e-2", "1cm").indenter.radius, 1e-2);
  EXPECT_EQ(with("modulus = 1e6", "1 MPa").elastomer.relaxed_modulus, 1e6);
  EXPECT_EQ(with("Normal frequency = 1", "2.5 kHz").motion.normal_frequency, 2500);
  EXPECT_NEAR(*with("Phase = 60", "0.5 rad").motion.phase, 28.64788975654116, 1e-13);
  EXPECT_EQ(with("times = 0.1", "100 ms").elastomer.branch_times[0], 0.1);
  expect_parts(refusal([&] { with("Radius = 1e-2", "10 Hz"); }), {"Indenter / Radius = 10 Hz", "mm", "nm"});
  expect_parts(refusal([&] { with("Normal frequency = 1", "1 mm"); }), {"Normal frequency = 1 mm", "kHz", "rad/s"});
  expect_parts(refusal([&] { with("Coefficient = 0.5", "0.5 m"); }), {"Coefficient = 0.5 m", "a pure number"});
}

TEST(EntryReader, TakesAUnitForEachOfAListOrTheLastForAll) {
  const auto moduli = [](const std::string& list) {
    const auto text = replace(valid_case, "moduli = 1e6\n  set Branch times = 0.1",
                              "moduli = " + list + "\n  set Branch times = 1, 2, 3");
    return read_case(replace(text, "standard solid", "prony")).elastomer.branch_moduli;
  };
  const std::vector<double> expected{1e6, 2e6, 3e6};
  EXPECT_EQ(moduli("1, 2, 3 MPa"), expected);
  EXPECT_EQ(moduli("1 MPa, 2000 kPa, 3e6 Pa"), expected);
  expect_parts(refusal([&] { moduli("1 MPa, 2, 3 MPa"); }), {"Branch moduli = 1 MPa, 2, 3 MPa", "or for the last one"});
  const auto harmonics =
      read_case(replace(valid_case, "Phase = 60", "Phase = 60\n  set Normal harmonics = 1 um, 3 Hz, 45 deg")).motion;
  EXPECT_EQ(harmonics.normal_harmonics[0].amplitude, 1e-6);
}

TEST(EntryReader, ReadsTheNumbersThatBelongToTheWordOfTheirSection) {
  const EntryTexts texts = [] {
    EntryTexts set;
    for (const auto& [name, text] : {std::pair("Flat radius", "1 mm"), {"Edge radius", "2 mm"}, {"Radius", "3 mm"}})
      set.set("Indenter", name, text);
    return set;
  }();
  Problems problems;
  Case::Indenter indenter;
  EntryReader(texts, "case.prm", problems).read_fields("Indenter", "rounded flat", indenter);
  EXPECT_EQ(indenter.flat_radius, 1e-3);
  EXPECT_EQ(indenter.edge_radius, 2e-3);
  EXPECT_EQ(indenter.radius, 0);
  ASSERT_EQ(problems.messages.size(), 1U);
  EXPECT_EQ(problems.messages[0],
            "case.prm: Indenter / Radius = 3 mm has no meaning here: it belongs to Shape = parabola or sphere or "
            "truncated sphere, not to rounded flat");
  EntryReader(EntryTexts(), "case.prm", problems).read_fields("Indenter", "table", indenter);
  EXPECT_EQ(problems.messages.size(), 1U) << "a Table noise that is not set is none";
  EntryReader(EntryTexts(), "case.prm", problems).read_fields("Indenter", "cone", indenter);
  expect_parts(problems.messages.back(),
               {"case.prm: Indenter / Slope angle is missing; expected an angle between 0 and 90 degrees, in deg"});
}

TEST(EntryReader, AsksWhetherAnotherWordWasMeant) {
  expect_parts(refusal([] { read_case(replace(valid_case, "parabola", "parobola")); }),
               {"Indenter / Shape = parobola", "did you mean parabola?"});
}

TEST(EntryReader, ShowsNoMoreOfAValueThanFitsInAMessage) {
  const auto message = refusal_of_phase(std::string(5000, 'x'));
  EXPECT_LT(message.size(), 500U);
  expect_parts(message, {"xxx..."});
}

TEST(EntryReader, FindsAFileBesideTheCaseFile) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "below");
  folder.write("pin.csv", "r,f\nm,m\n0,0\n1e-4,1e-6\n2e-4,4e-6\n3e-4,9e-6\n");
  const auto table_of = [&](const std::string& name) {
    const auto text = replace(valid_case, "parabola\n  set Radius = 1e-2", "table\n  set Table = " + name);
    return read_case_file(folder.write("below/case.prm", text)).at(0).indenter.table;
  };
  EXPECT_TRUE(std::filesystem::equivalent(table_of("../pin.csv"), folder.path() / "pin.csv"));
  for (const char* none : {"pin.csv", ".."})
    expect_parts(refusal([&] { table_of(none); }), {"Indenter / Table", "relative to the case file"});
}

}  // namespace
}  // namespace fretval
