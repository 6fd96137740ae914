#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "tests/comparison/damaged_case.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::result_schema_test {
namespace {

namespace fs = std::filesystem;

/// What a validator of somebody else's says of files, each by its name; empty: nothing.
std::string said_of(const std::vector<fs::path>& files, const ScratchFolder& folder) {
  std::string command = "python3 -W ignore -m jsonschema --output pretty";
  for (const auto& file : files) command += " -i " + quoted(file);
  const auto run = shell_run(command + " " + quoted(fs::path(FRETVAL_SOURCE_DIR) / "docs/result.schema.json"), folder);
  return run.err;
}

/// Every kind of result: with bars, beyond MDR, of a sweep, unlocked, limiting, with forces, gross slip, with
/// harmonics, worn, along a path, also of forces, of data and beside what was measured, worn by friction as a vector.
fs::path run_of_every_kind(const ScratchFolder& folder) {
  const auto elastic = elastic_case();
  const auto limiting = "subsection Wear\n  set State = limiting\n  set Stick radius ratio = 0.5\nend\n";
  const auto with_force = [&](const char* amplitude) {
    return replace(elastic, "Tangential amplitude = 1.5e-5", std::string("Tangential force amplitude = ") + amplitude);
  };
  folder.write("bars.prm", replace(valid_case, "Tolerance = 0.01", "Tolerance = 0.05"));
  folder.write("sweep.prm",
               elastic + "subsection Sweep\n  set Entry = Accuracy / Rings per radius\n  set Values = 16, 24\nend\n");
  folder.write("free.prm", replace(elastic, "Phase = 60", "Phase = free"));
  folder.write("limiting.prm",
               replace(elastic, "Tangential amplitude = 1.5e-5", "Tangential amplitude = shakedown") + limiting);
  folder.write("force.prm", with_force("0.05 N"));
  folder.write("gross.prm", with_force("10 N"));
  folder.write("harmonics.prm",
               replace(elastic, "Phase = 60", "Phase = 60\n  set Normal harmonics = 5 um, 2 Hz, 0 deg"));
  folder.write("circle.prm",
               replace(wearing_in_a_circle_text(), "Coefficient = 1e-12", "Coefficient = 1e-12\n  set Cycles = 100"));
  folder.write("worn.prm", elastic + "subsection Wear\n  set Coefficient = 1e-12\n  set Cycles = 100\nend\n");
  const auto begin = elastic.find("subsection Motion"), end = elastic.find("subsection Accuracy");
  folder.write("path.csv", "t,d,u_x\ns,um,um\n0,100,0\n1,120,8\n2,100,0\n");
  for (const std::string repeats : {"once", "forever"})
    folder.write(repeats + ".prm", elastic.substr(0, begin) +
                                       "subsection Motion\n  set Path = path.csv\n  set Path repeats = " + repeats +
                                       "\nend\n" + elastic.substr(end));
  for (const std::string pull : {"0.05", "0.4"}) {
    folder.write("pull-" + pull + ".csv", "t,F_N,F_x\ns,N,N\n0,0.5,0\n1,0.6," + pull + "\n");
    folder.write("pull-" + pull + ".prm", elastic.substr(0, begin) + "subsection Motion\n  set Path = pull-" + pull +
                                              ".csv\n  set Path repeats = once\nend\n" + elastic.substr(end));
  }
  folder.write("duration.prm", replace(replace(valid_case, "Tolerance = 0.01", "Tolerance = 0.05"),
                                       "Branch times = 0.1", "Branch times = 0.1\n  set Duration of the test = 1 h"));
  folder.write("record.csv", "t;d;u_x\ns;um;um\n0;100;0\n1;120;8\n2;100,1;0\n");
  folder.write("data.prm",
               replace(elastic.substr(0, begin), "Relaxed shear modulus = 1e6", "Shore A = 50") +
                   "subsection Motion\n  set Path = record.csv\n  set Path repeats = forever\nend\n" +
                   elastic.substr(end) +
                   "subsection Measured\n  set Stick radius = 0.8 mm\n  set Stick radius uncertainty = 20 um\nend\n");
  write_damaged_case(folder, groove(0.5, 0.7, 0.04));
  const auto out = folder.path() / "out";
  const auto run = fretval_run("-q run --proof bars " + quoted(folder.path()) + " -o " + quoted(out), folder);
  EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 1 || run.exit_code == 5) << run.err;
  return out;
}

TEST(ResultSchema, HoldsForEveryKindOfResult) {
  const ScratchFolder folder;
  std::vector<fs::path> results;
  for (const auto& entry : fs::recursive_directory_iterator(run_of_every_kind(folder)))
    if (entry.path().filename() == "result.json") results.push_back(entry.path());
  EXPECT_EQ(results.size(), 17U);
  EXPECT_EQ(said_of(results, folder), "");
}

TEST(ResultSchema, RefusesWhatItDoesNotSay) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  ASSERT_EQ(fretval_run("run --proof none " + quoted(file) + " -o " + quoted(folder.path()), folder).exit_code, 0);
  const auto good = nlohmann::json::parse(text_of(folder.path() / "case/result.json"));
  std::vector<fs::path> files;
  for (const char* patch : {R"({})", R"({"schema": 1})", R"({"note": 1})", R"({"cost": {"dofs": "many"}})",
                            R"({"cost": {"all": {"time_steps": -1}}})", R"({"mdr": {"modulus_ratio": null}})",
                            R"({"scene": {"wear": "much"}})", R"({"scene": {"data": {"hardness": {"shore_a": 50}}}})",
                            R"({"measured": {"normal_force_max": {"value": 1}}})",
                            R"({"comparison": {"normal_force_max": {"tolerance": 0}}})",
                            R"({"comparison": {"weight": {"tolerance": 1}}})"}) {
    auto json = good;
    json.merge_patch(nlohmann::json::parse(patch));
    files.push_back(folder.write("changed-" + std::to_string(files.size()) + ".json", json.dump()));
  }
  const auto said = said_of(files, folder);
  for (std::size_t i = 0; i < files.size(); ++i)
    EXPECT_EQ(said.find(files[i].filename().string()) != std::string::npos, i > 0) << text_of(files[i]) << said;
}

}  // namespace
}  // namespace fretval::result_schema_test
