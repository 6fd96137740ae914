#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

TEST(MdrCommand, PrintsTheAnalyticAnswerAsText) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", valid_case + "subsection Wear\n  set Coefficient = 1e-15\n  set Cycles = 1000\nend\n");
  const auto run = fretval_run("mdr " + file.string() + " --springs", folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("case\n  modulus ratio ", 0), 0U) << run.out;
  for (const char* label : {"largest contact radius", "stick radius, shakedown", "outer radius of the wear",
                            "springs: shakedown", "springs: friction per cycle", "worn volume"})
    EXPECT_NE(run.out.find(std::string("\n  ") + label + " "), std::string::npos) << label << "\n" << run.out;
  EXPECT_NE(run.out.find(" m^3 after 1000 cycles\n"), std::string::npos) << run.out;
}

TEST(MdrCommand, PrintsWhereNothingSticks) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "amplitude = 1.5e-5", "amplitude = 5e-4"));
  const auto run = fretval_run("mdr " + file.string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("stick radius, shakedown     none (nothing sticks)\n"), std::string::npos) << run.out;
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

}  // namespace
}  // namespace fretval
