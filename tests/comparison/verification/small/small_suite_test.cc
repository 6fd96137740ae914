#include "comparison/verification/small/small_suite.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fretval {
namespace {

/// Which of the scenes pass after the finite element side was tampered with.
template <class Tamper>
std::vector<BatchLine> tampered(Tamper tamper) {
  auto scenes = check_scenes(small_meshes());
  // The fine mesh has the tighter tolerances; one mesh is enough to show that a guard works.
  scenes.erase(std::remove_if(scenes.begin(), scenes.end(),
                              [](const CheckScene& scene) { return scene.mesh.filename() != "fine.msh"; }),
               scenes.end());
  for (auto& scene : scenes) tamper(scene.prepared.fem);
  return run_check(scenes);
}

bool none_pass(const std::vector<BatchLine>& lines) {
  return std::none_of(lines.begin(), lines.end(), [](const BatchLine& line) { return line.pass; });
}

TEST(Check, PassesOnTheCommittedMeshes) {
  const auto lines = run_check(check_scenes(small_meshes()));
  ASSERT_EQ(lines.size(), 6U);
  for (const auto& line : lines) EXPECT_TRUE(line.pass) << line.name << ' ' << line.failure;
}

TEST(CheckGuard, FailsWithoutFriction) {
  EXPECT_TRUE(none_pass(tampered([](FemCase& scene) { scene.friction_coefficient = 0; })));
}

TEST(CheckGuard, FailsWithoutNormalOscillation) {
  EXPECT_TRUE(none_pass(tampered([](FemCase& scene) { scene.motion.normal_amplitude = 0; })));
}

TEST(CheckGuard, FailsWithoutViscosity) {
  EXPECT_TRUE(none_pass(tampered([](FemCase& scene) { scene.relaxation = {}; })));
}

TEST(CheckGuard, FailsWithAnotherPhase) {
  EXPECT_TRUE(none_pass(tampered([](FemCase& scene) { *scene.motion.phase += 0.1; })));
}

TEST(CheckGuard, FailsWithAnotherProfile) {
  EXPECT_TRUE(none_pass(
      tampered([](FemCase& scene) { scene.profile = [f = scene.profile](double r) { return 1.01 * f(r); }; })));
}

TEST(Check, WritesJUnitXml) {
  BatchLine good, bad;
  good.name = "good";
  good.pass = true;
  bad.name = "<bad>";
  bad.verdict["normal_force_max"] = {0.5, 0.1, Verdict::fail};
  const auto xml = junit_xml({good, bad});
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"good\"/>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"&lt;bad&gt;\"><failure message=\"normal_force_max: difference 5.00e-01"),
            std::string::npos)
      << xml;
}

TEST(CheckJUnit, SaysWhatFailed) {
  BatchLine good, off, stuck, broken, silent;
  good.name = "good";
  good.pass = true;
  good.verdict = {{"normal_force_max", {1e-5, 1e-4, Verdict::pass}}};
  off.name = "off";
  off.verdict = {{"normal_force_max", {2e-3, 1e-4, Verdict::fail}}};
  stuck.name = "stuck";
  stuck.verdict = {{"stick_radius_shakedown", {std::nullopt, 1e-3, Verdict::fail}}};
  broken.name = "broken";
  broken.failure = "a < b";
  silent.name = "silent";
  const auto xml = junit_xml({good, off, stuck, broken, silent});
  for (const char* part :
       {"tests=\"5\" failures=\"4\"", "name=\"good\"/>", "normal_force_max: difference 2.00e-03, tolerance 1.0e-04",
        "stick_radius_shakedown: difference none, tolerance 1.0e-03", "message=\"a &lt; b\"", "message=\"failed\""})
    EXPECT_NE(xml.find(part), std::string::npos) << part << "\nin\n" << xml;
}

}  // namespace
}  // namespace fretval
