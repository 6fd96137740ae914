#include "comparison/run/sweep_line.h"

#include <gtest/gtest.h>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

std::filesystem::path swept(const ScratchFolder& folder, const std::string& entry, const std::string& values,
                            const std::string& text = elastic_case()) {
  return folder.write("swept.prm",
                      text + "subsection Sweep\n  set Entry = " + entry + "\n  set Values = " + values + "\nend\n");
}

/// computed: nothing, unless it is said.
void write_lines(const std::vector<Case>& cases, const std::filesystem::path& output,
                 std::vector<BatchLine> computed = {}) {
  SweepLines lines(cases);
  const auto work = lines.work();
  for (std::size_t i = 0; i < work.n; ++i) work.take(i, work.compute(i));
  computed.resize(cases.size());
  lines.write(output, computed);
}

TEST(SweepLine, NamesTheUnitOfTheEntry) {
  EXPECT_EQ(unit_of_entry("Motion / Phase"), "deg");
  EXPECT_EQ(unit_of_entry("Friction / Coefficient"), "");
  EXPECT_EQ(symbol_of_entry("Motion / Phase"), "φ_0");
  EXPECT_EQ(symbol_of_entry("Wear / Cycles"), "");
  EXPECT_EQ(symbol_of_entry("Motion / Nothing"), "");
  EXPECT_EQ(column_of_entry("Motion / Phase"), "Motion / Phase [deg]");
  EXPECT_EQ(column_of_entry("Friction / Coefficient"), "Friction / Coefficient [1]");
  EXPECT_EQ(column_of_entry("Elastomer / Relaxed shear modulus"), "Elastomer / Relaxed shear modulus [Pa]");
}

// Against the answer to a case of its own, and a = sqrt(R (d0 + delta)) of the parabola.
TEST(SweepLine, IsTheAnswerAtValuesBetween) {
  const ScratchFolder folder;
  const auto file = swept(folder, "Indenter / Radius", "5, 10, 20 mm");
  write_lines(read_case_file(file), folder.path());
  const auto [value, radius] =
      read_sweep_line(folder.path() / "swept", "Indenter / Radius", Quantity::contact_radius_max);
  ASSERT_EQ(value.size(), 101U);
  EXPECT_NEAR(value[25], 7.5e-3, 1e-12);
  EXPECT_NEAR(value[75], 15e-3, 1e-12);
  for (std::size_t i = 0; i < value.size(); ++i) EXPECT_NEAR(radius[i] / std::sqrt(value[i] * 1.2e-4), 1, 1e-9);
  const auto [same, stick] =
      read_sweep_line(folder.path() / "swept", "Indenter / Radius", Quantity::stick_radius_shakedown);
  const auto between = mdr_case(read_case(replace(elastic_case(), "1e-2", "15 mm")));
  EXPECT_NEAR(stick[75] / mdr_answer(between, mdr_normal_response(between)).stick_radius_shakedown.value(), 1, 1e-9);
}

// Beside other sweeps springs are stepped at 24 values: of a sweep that has 25, no more.
TEST(SweepLine, IsNotSteppedWhereResultsHaveAsManyValues) {
  const ScratchFolder folder;
  auto cases = read_case_file(swept(folder, "Motion / Tangential amplitude", "4:0.1:6.4 um"));
  ASSERT_EQ(cases.size(), 25U);
  for (const char* name : {"b", "c", "d", "e"}) {
    cases.push_back(cases.front());
    cases.back().sweep->family = name;
  }
  write_lines(cases, folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "swept/mdr.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "swept/mdr_springs.csv"));
}

// Against the answer to a case of its own.
TEST(SweepLine, HasWhatSpringsAreSteppedFor) {
  const ScratchFolder folder;
  write_lines(read_case_file(swept(folder, "Motion / Tangential amplitude", "4, 6 um")), folder.path());
  const auto line = [&](Quantity quantity) {
    return read_sweep_line(folder.path() / "swept", "Motion / Tangential amplitude", quantity);
  };
  const auto [amplitude, force] = line(Quantity::tangential_force_max);
  ASSERT_EQ(amplitude.size(), 101U);
  const auto between =
      mdr_case(read_case(replace(elastic_case(), "Tangential amplitude = 1.5e-5", "Tangential amplitude = 5e-6")));
  const auto answer = mdr_answer_with_cycle(between, mdr_normal_response(between));
  EXPECT_NEAR(amplitude[50], 5e-6, 1e-15);
  EXPECT_NEAR(force[50] / answer.cycle->value(Quantity::tangential_force_max), 1, 1e-9);
  EXPECT_NEAR(line(Quantity::friction_work).second[50] / answer.cycle->value(Quantity::friction_work), 1, 1e-9);
  EXPECT_NEAR(line(Quantity::normal_force_max).second[50] / answer.normal_force_max.value(), 1, 1e-9);
  EXPECT_EQ(line(Quantity::contact_radius_max).second.size(), 101U) << "has a closed form";
  EXPECT_TRUE(line(Quantity::worn_volume).second.empty()) << "nothing wears";
}

TEST(SweepLine, HasTheAnswersOfTheCasesThemselves) {
  const ScratchFolder folder;
  std::vector<BatchLine> computed(2);
  computed[1].json = R"({"mdr": {"tangential_force_max": 42, "cycles_to_shakedown": 7}})";
  write_lines(read_case_file(swept(folder, "Motion / Tangential amplitude", "4, 6 um")), folder.path(), computed);
  const auto line = [&](Quantity quantity) {
    return read_sweep_line(folder.path() / "swept", "Motion / Tangential amplitude", quantity).second;
  };
  const auto force = line(Quantity::tangential_force_max);
  ASSERT_EQ(force.size(), 101U);
  EXPECT_EQ(force[100], 42);
  EXPECT_LT(force[99], 42);
  EXPECT_TRUE(line(Quantity::cycles_to_shakedown).empty()) << "not known between the points";
}

// Of every kind of case whose radii springs are stepped for too: all of a line is that of one answer.
TEST(SweepLine, IsSteppedWhereNothingHasAClosedForm) {
  const auto force = replace(elastic_case(), "Indentation = 1e-4\n  set Normal amplitude = 2e-5",
                             "Normal force = 0.5\n  set Normal force amplitude = 0.1");
  const auto harmonics = replace(elastic_case(), "Phase = 60", "Phase = 60\n  set Normal harmonics = 5e-6, 2, 30");
  const auto layer =
      elastic_case() + "subsection Body\n  set Shape = layer\n  set Thickness = 2 mm\n  set Base = bonded\nend\n";
  for (const auto& text : {force, harmonics, layer}) {
    const ScratchFolder folder;
    write_lines(read_case_file(swept(folder, "Friction / Coefficient", "0.3, 0.5", text)), folder.path());
    const auto line = [&](Quantity quantity) {
      return read_sweep_line(folder.path() / "swept", "Friction / Coefficient", quantity);
    };
    auto between = mdr_case(read_case(replace(text, "Coefficient = 0.5", "Coefficient = 0.4")));
    const auto at_a_point = mdr_answer_with_cycle(between, mdr_normal_response(between));
    if (between.has_forces()) between.coarser_springs = 2;
    const auto answer = mdr_answer_with_cycle(between, mdr_normal_response(between));
    const auto [friction, radius] = line(Quantity::stick_radius_shakedown);
    ASSERT_EQ(friction.size(), 25U);
    EXPECT_NEAR(friction[12], 0.4, 1e-12);
    EXPECT_NEAR(radius[12] / answer.stick_radius_shakedown.value(), 1, 1e-9);
    EXPECT_NEAR(line(Quantity::tangential_force_max).second[12] / answer.cycle->value(Quantity::tangential_force_max),
                1, 1e-9);
    EXPECT_NEAR(radius[12] / at_a_point.stick_radius_shakedown.value(), 1, 1e-5);
    EXPECT_NEAR(line(Quantity::friction_work).second[12] / at_a_point.cycle->value(Quantity::friction_work), 1, 3e-3);
    EXPECT_EQ(line(Quantity::indentation_max).second.empty(), !answer.indentation_max);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "swept" / "mdr.csv"));
  }
}

// The table is that of the example, whose fit takes most of the time.
TEST(SweepLine, IsThatOfMeasuredModuliToo) {
  const ScratchFolder folder;
  const auto examples = std::filesystem::path(FRETVAL_SOURCE_DIR) / "cases/examples";
  std::filesystem::copy(examples / "rubber-dma.csv", folder.path());
  const auto text = "include " + (examples / "measured-rubber.prm").string() + "\n";
  write_lines(read_case_file(swept(folder, "Friction / Coefficient", "0.3, 0.5", text)), folder.path());
  const auto [friction, radius] =
      read_sweep_line(folder.path() / "swept", "Friction / Coefficient", Quantity::stick_radius_shakedown);
  ASSERT_EQ(radius.size(), 25U);
  for (std::size_t i = 1; i < radius.size(); ++i) EXPECT_GT(radius[i], radius[i - 1]);
}

// The figures of the paper are dozens of families, which share the values of one.
TEST(SweepLine, IsThereForEachOfSeveralSweeps) {
  const ScratchFolder folder;
  auto cases = read_case_file(swept(folder, "Motion / Phase", "0, 90"));
  auto other = cases;
  for (auto& one : other) one.sweep->family = "other";
  cases.insert(cases.end(), other.begin(), other.end());
  write_lines(cases, folder.path());
  for (const char* family : {"swept", "other"})
    EXPECT_EQ(read_sweep_line(folder.path() / family, "Motion / Phase", Quantity::tangential_force_max).second.size(),
              51U);
}

TEST(SweepLine, IsNotThereWhereItWouldMeanNothing) {
  const ScratchFolder folder;
  const auto is_written = [&](const std::filesystem::path& file) {
    write_lines(read_case_file(file), folder.path());
    return std::filesystem::exists(folder.path() / "swept" / "mdr.csv");
  };
  EXPECT_TRUE(is_written(swept(folder, "Friction / Coefficient", "0.3, 0.5")));
  EXPECT_FALSE(is_written(swept(folder, "Friction / Coefficient", "0.3"))) << "that of before is gone";
  EXPECT_FALSE(is_written(swept(folder, "Accuracy / Rings per radius", "32, 48")));
  EXPECT_TRUE(is_written(swept(folder, "Friction / Coefficient", "0.3, 0.5")));
  EXPECT_FALSE(is_written(swept(folder, "Friction / Coefficient",
                                "0.3, 0.5\n  set Second entry = Motion / Phase\n  set Second values = 0, 90")))
      << "a map has no line";
}

// Without a first-slip zone from a small friction on.
TEST(SweepLine, HasNoNumberWhereNothingSticks) {
  const ScratchFolder folder;
  write_lines(read_case_file(swept(folder, "Friction / Coefficient", "1e-3, 0.5")), folder.path());
  const auto stick =
      read_sweep_line(folder.path() / "swept", "Friction / Coefficient", Quantity::stick_radius_first_slip).second;
  EXPECT_TRUE(std::isnan(stick.front()));
  EXPECT_GT(stick.back(), 0);
}

}  // namespace
}  // namespace fretval
