#include "comparison/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/case.h"
#include "comparison/report/exact_section.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

nlohmann::json stored_phase() {
  return nlohmann::json::parse(text_of(fs::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json/phase.json"));
}

/// The report of results, each in a folder of its own.
std::string page_of(const std::vector<nlohmann::json>& results) {
  const ScratchFolder folder;
  for (std::size_t i = 0; i < results.size(); ++i) {
    fs::create_directories(folder.path() / std::to_string(i));
    folder.write(std::to_string(i) + "/result.json", results[i].dump());
  }
  return text_of(write_report(folder.path()));
}

const std::string heading = "Does only the modulus ratio matter?";

TEST(Report, ComparesRheologiesByTheirLargestDifferences) {
  auto solid = stored_phase(), other_phase = stored_phase(), creeping = stored_phase();
  solid["comparison"]["stick_radius_shakedown"]["difference"] = 1.25e-4;
  other_phase["scene"]["sweep"]["value"] = 90;
  other_phase["comparison"]["stick_radius_shakedown"]["difference"] = -3.5e-4;
  other_phase["cost"]["cycles"] = 77;
  creeping["scene"]["rheology"] = "Kelvin-Voigt";
  creeping["mdr"]["modulus_ratio"] = 1.5;
  creeping["comparison"]["stick_radius_first_slip"]["difference"] = 6.5e-4;
  creeping["comparison"]["stick_radius_shakedown"]["difference"] = 7.5e-5;
  creeping["cost"]["cycles"] = 123;
  EXPECT_EQ(page_of({solid, other_phase}).find(heading), std::string::npos) << "one rheology compares with nothing";
  const auto page = page_of({solid, other_phase, creeping});
  const auto section = page.substr(std::min(page.find(heading), page.size()));
  EXPECT_NE(section.find("<td>Kelvin-Voigt</td><td>1.500000</td><td>1</td><td>6.5e-04</td><td>7.5e-05</td>"
                         "<td>up to 123</td>"),
            std::string::npos)
      << section.substr(0, 2000);
  EXPECT_NE(section.find("<td>standard solid</td><td>1.359827</td><td>2</td>"), std::string::npos);
  EXPECT_NE(section.find("<td>-3.5e-04</td><td>up to 77</td>"), std::string::npos);
}

TEST(Report, SaysWhichStickRadiusTheSteadyStateFollows) {
  const auto as_stored = stored_phase();
  expect_parts(page_of({as_stored}), {"it follows the shakedown radius", "Over 1 cases"});
  auto equal = stored_phase();
  for (const char* side : {"fe", "mdr"})
    equal[side]["stick_radius_first_slip"] = equal[side]["stick_radius_shakedown"] = 0.0008;
  expect_parts(page_of({equal}), {"it does not single out the shakedown radius"});
  auto never = stored_phase();
  never["mdr"]["stick_radius_first_slip"] = nullptr;
  expect_parts(page_of({never}), {"In 1 of the cases the first-slip criterion says that nothing sticks"});
  auto nothing = stored_phase();
  for (const char* side : {"fe", "mdr"}) nothing[side]["stick_radius_shakedown"] = nullptr;
  EXPECT_EQ(page_of({nothing}).find("Which stick radius do finite elements follow?"), std::string::npos);
}

// The figures of the paper: other shapes stand in the tables alone.
TEST(Report, HasFiguresOfTheShapesOfThePaper) {
  const std::vector<std::pair<std::string, std::string>> titles{
      {"parabola", "Parabola:"}, {"cone", "Cone:"}, {"power", "Power law:"}};
  for (const char* shape : {"parabola", "cone", "power", "rounded flat"}) {
    auto first = stored_phase(), second = stored_phase();
    second["scene"]["sweep"]["value"] = 90;
    for (auto* json : {&first, &second}) (*json)["scene"]["shape"] = shape;
    const auto page = page_of({first, second});
    for (const auto& [name, title] : titles) EXPECT_EQ(page.find(title) != std::string::npos, name == shape) << title;
    EXPECT_NE(page.find("family/phase-30"), std::string::npos) << shape;
  }
}

TEST(Report, RefusesAFolderWithoutResultsAndDamagedTables) {
  const ScratchFolder folder;
  const auto refusal = [&] {
    try {
      write_report(folder.path());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(refusal().find("there is no result.json, trade.json"), std::string::npos) << refusal();
  folder.write("result.json", stored_phase().dump());
  EXPECT_EQ(refusal(), "no error");
  folder.write("exact.json", "[{");
  EXPECT_NE(refusal().find("exact.json: "), std::string::npos) << refusal();
}

TEST(Report, MarksWhatDoesNotAgree) {
  auto single = stored_phase();
  single["scene"].erase("sweep");
  expect_parts(page_of({single}), {"standard solid: finite elements and MDR agree."});
  single["pass"] = false;
  single["comparison"]["normal_force_max"]["pass"] = false;
  single["comparison"]["stick_radius_shakedown"]["difference"] = nullptr;
  const auto page = page_of({single});
  expect_parts(page, {"standard solid: they do not agree.", "<td class=\"bad-cell\">4.4e-05</td><td>1.0e-03</td>",
                      "<td>–</td><td>1.0e-02</td>", "<td class=\"bad-cell\">disagree</td>"});
}

nlohmann::ordered_json convergence_row() {
  return {{"scene", "Hertz"},
          {"quantity", "force"},
          {"source", "Hertz 1882"},
          {"refined", "rings"},
          {"resolutions", {16, 32}},
          {"errors", {1e-3, 2.5e-4}},
          {"observed_order", 2.0},
          {"expected_order", 2},
          {"tolerance", 1e-3},
          {"goal", 1e-6},
          {"goal_met", true},
          {"verdict", "pass"},
          {"note", ""}};
}

TEST(ConvergenceSection, HasErrorsOrdersGoalsAndVerdictsOfEachRow) {
  auto failing = convergence_row(), plain = convergence_row();
  failing["errors"][1] = nullptr;
  failing["observed_order"] = nullptr;
  failing["goal_met"] = false;
  failing["verdict"] = "the error is <not> finite";
  plain["goal"] = plain["goal_met"] = nullptr;
  plain["note"] = "to roundoff";
  const auto html = convergence_section({convergence_row(), failing, plain});
  const std::string not_finite =
      "<td title=\"32 rings\">not finite</td><td>floor (2)</td><td>1e-03</td><td>1e-06, not met</td>"
      "<td class=\"bad-cell\">the error is &lt;not&gt; finite</td>";
  expect_parts(html,
               {"2 of 3 rows pass; 1 of 2 goals", "<td title=\"16 rings\">1.0e-03</td>",
                "<td title=\"32 rings\">2.5e-04</td><td>2.0 (2)</td><td>1e-03</td><td>1e-06, met</td><td>pass</td>",
                not_finite, "<td>–</td><td>pass</td><td class=\"words\">Hertz 1882; to roundoff</td>"});
}

TEST(Report, DoesWithoutResultsWhereASuiteWasRun) {
  const ScratchFolder folder;
  folder.write("exact.json", nlohmann::json::array({convergence_row()}).dump());
  const auto page = text_of(write_report(folder.path()));
  expect_parts(page, {"1 of 1 rows pass"});
  EXPECT_EQ(page.find("All cases"), std::string::npos);
}

TEST(Report, RefusesADamagedFileOfASuiteByItsName) {
  for (const char* name : {"tolerance.json", "extremes.json", "random.json", "exact.json"}) {
    const ScratchFolder folder;
    folder.write(name, R"({"records": [1]})");
    try {
      write_report(folder.path());
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(folder.path() / "index.html")) << name;
  }
}

}  // namespace
}  // namespace fretval
