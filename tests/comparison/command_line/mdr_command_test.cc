#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/reference/mdr_document.h"
#include "comparison/results/unit_text.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(MdrCommand, PrintsTheAnalyticAnswerAsJson) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run("mdr " + file.string() + " --json", folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("name"), "case");
  for (const char* key : {"modulus_ratio", "contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown",
                          "worn_radius", "normal_force_max"})
    EXPECT_TRUE(json.at("mdr").contains(key)) << key;
  EXPECT_EQ(json.at("limiting_profile").at("criterion"), "shakedown");
  EXPECT_EQ(json.at("limiting_profile").at("r").size(), json.at("limiting_profile").at("f").size());
}

// The document of the case has the same numbers under keys; here each has its words, and its unit as a run shows it.
TEST(MdrCommand, PrintsTheAnalyticAnswerAsText) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", valid_case + "subsection Wear\n  set Coefficient = 1e-15\n  set Cycles = 1000\nend\n");
  const auto run = fretval_run("mdr " + file.string() + " --springs", folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("case\n                               MDR                          springs\n", 0), 0U)
      << run.out;
  const auto json = mdr_document(read_case_file(file).at(0), true).json;
  const auto expect_line = [&](const char* words, const char* key, const char* unit, double factor, int decimals,
                               const char* of_springs = "") {
    const auto& springs = json.at("springs");
    const auto value = fmt::format("{:.{}f} {}", json.at("mdr").at(key).get<double>() / factor, decimals, unit);
    auto line = fmt::format("\n  {:<28} {}", words, value);
    if (springs.contains(key))
      line += fmt::format("{:{}} {:.{}f}", "", 28 - value.size() + (value.find("µ") != std::string::npos ? 1 : 0),
                          springs.at(key).get<double>() / factor, decimals);
    expect_parts(run.out, {line + of_springs});
  };
  expect_line("largest contact radius", "contact_radius_max", "mm", 1e-3, 5, "\n");
  expect_line("stick radius, first slip", "stick_radius_first_slip", "µm", 1e-6, 3, " µm\n");
  expect_line("stick radius, shakedown", "stick_radius_shakedown", "µm", 1e-6, 3, " µm\n");
  expect_line("outer radius of the wear", "worn_radius", "mm", 1e-3, 5, "\n");
  expect_line("largest normal force", "normal_force_max", "mN", 1e-3, 3, " mN\n");
  expect_line("largest pressure on the axis", "axis_pressure_max", "kPa", 1e3, 3, "\n");
  expect_parts(run.out,
               {fmt::format("\n  {:<28} {:.6g}\n", "modulus ratio", json.at("mdr").at("modulus_ratio").get<double>())});
  const auto& volume = json.at("wear").at("volume");
  EXPECT_GT(volume.back(), volume.front());
  expect_parts(run.out, {fmt::format("\n  {:<28} {:.6g} mm³ after 1000 cycles\n", "worn volume",
                                     1e9 * volume.back().get<double>())});
}

// What springs are stepped for has digits as far as they are right.
TEST(MdrCommand, PrintsTheErrorOfSprings) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run("mdr " + file.string(), folder);
  const auto mdr = mdr_document(read_case_file(file).at(0), false).json.at("mdr");
  const auto expect_line = [&](const char* words, const char* key, const char* error, const char* unit) {
    expect_parts(run.out, {fmt::format("\n  {:<28} {}\n", words,
                                       with_unit(mdr.at(key), mdr.at("cycle_error").at(error), unit))});
    EXPECT_GT(mdr.at("cycle_error").at(error), 0);
  };
  expect_line("largest tangential force", "tangential_force_max", "force", "N");
  expect_line("mean tangential force", "tangential_force_mean", "force", "N");
  expect_line("energy lost to friction", "friction_work", "work", "J");
  expect_line("energy lost in the body", "bulk_work", "work", "J");
  expect_line("energy lost altogether", "cycle_work", "work", "J");
  expect_line("area of the tangential loop", "tangential_work", "loop", "J");
}

// What a run compares of forces is the unworn contact.
TEST(MdrCommand, SaysThatForcesAreAnsweredForTheWornContact) {
  const ScratchFolder folder;
  const auto text = replace(replace(valid_case, "Indentation = 1e-4", "Normal force = 0.5"), "Normal amplitude = 2e-5",
                            "Normal force amplitude = 0.1");
  const auto run = fretval_run("mdr " + folder.write("case.prm", text).string(), folder);
  EXPECT_EQ(run.out.rfind("case: under prescribed forces, of the contact that has worn to its end\n", 0), 0U)
      << run.out << run.err;
  expect_parts(run.out, {"largest contact radius, worn "});
}

TEST(MdrCommand, WarnsWhereSpringsStillSettle) {
  const ScratchFolder folder;
  auto text = replace(valid_case, "Branch moduli = 1e6\n  set Branch times = 0.1",
                      "Branch moduli = 7e6\n  set Branch times = 0.5");
  text = replace(replace(text, "Normal amplitude = 2e-5", "Normal amplitude = 1.2e-5"), "1.5e-5", "8.823529e-6");
  const auto file = folder.write("case.prm", replace(text, "Phase = 60", "Phase = 0"));
  expect_parts(fretval_run("mdr " + file.string() + " --springs", folder).err, {"case: shakedown radius 0.001"});
  EXPECT_EQ(fretval_run("mdr " + file.string(), folder).err.find("shakedown radius"), std::string::npos);
}

TEST(MdrCommand, PrintsWhereNothingSticks) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "amplitude = 1.5e-5", "amplitude = 5e-4"));
  const auto run = fretval_run("mdr " + file.string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("stick radius, shakedown      none (nothing sticks)\n"), std::string::npos) << run.out;
}

TEST(MdrCommand, WritesTheFieldsOnTheSurface) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto fields = folder.path() / "fields.csv";
  ASSERT_EQ(fretval_run("mdr " + file.string() + " --fields " + fields.string(), folder).exit_code, 0);
  EXPECT_EQ(text_of(fields).rfind("r [m],f [m],p deepest [Pa],", 0), 0U);
}

TEST(MdrCommand, AnswersASweepWithAListAndHasNoFieldsOfIt) {
  const ScratchFolder folder;
  const auto file =
      folder.write("sweep.prm", replace(valid_case, "Radius = 1e-2", "Radius = 1e-7") +
                                    "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto run = fretval_run("mdr " + file.string() + " --json", folder);
  EXPECT_EQ(run.exit_code, 0);
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(json[k].at("name"), "sweep/phase-" + std::to_string(90 * k));
  EXPECT_NE(run.err.find("slope"), std::string::npos) << "100 um into a radius of 100 nm is implausible: " << run.err;
  const auto fields = fretval_run("mdr " + file.string() + " --fields " + (folder.path() / "f.csv").string(), folder);
  EXPECT_EQ(fields.exit_code, 2);
  EXPECT_NE(fields.err.find("a sweep has many fields"), std::string::npos) << fields.err;
}

// What the document has as a share.
TEST(MdrCommand, PrintsTheMisfitOfAPronyFitInPercent) {
  const ScratchFolder folder;
  folder.write("dma.csv", standard_solid_table(1.3));
  const auto begin = valid_case.find("subsection Elastomer"), end = valid_case.find("end\n", begin);
  const auto file = folder.write("case.prm", valid_case.substr(0, begin) +
                                                 "subsection Elastomer\n  set Rheology = table\n  set Table = dma.csv\n"
                                                 "  set Table modulus = shear\n" +
                                                 valid_case.substr(end));
  const auto text = fretval_run("mdr " + quoted(file), folder),
             json = fretval_run("mdr --json " + quoted(file), folder);
  ASSERT_EQ(text.exit_code, 0) << text.err;
  const auto fit = nlohmann::json::parse(json.out).at("elastomer");
  const double misfit = fit.at("residual"), held_out = fit.at("held_out");
  EXPECT_GT(misfit, 1e-2);
  const auto printed = [&](const std::string& what) {
    const auto at = text.out.find("Prony fit: " + what);
    EXPECT_NE(at, std::string::npos) << text.out;
    return std::stod(text.out.substr(text.out.find_first_of("0123456789", at)));
  };
  EXPECT_NEAR(printed("misfit"), 100 * misfit, 5 * misfit);
  EXPECT_NEAR(printed("held out"), 100 * held_out, 5 * held_out);
}

}  // namespace
}  // namespace fretval
