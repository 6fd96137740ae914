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

TEST(CaseInputs, NameTheAmplitudeThatFollows) {
  Case input{};
  input.motion.tangential_amplitude = std::nan("");
  std::map<std::string, nlohmann::ordered_json> found;
  for (const auto& one : inputs_json(input)) found[one.at("name")] = one.at("value");
  EXPECT_EQ(found.at("Tangential amplitude"), "shakedown");
}

}  // namespace
}  // namespace fretval
