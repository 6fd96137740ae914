#include "comparison/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

}  // namespace
}  // namespace fretval
