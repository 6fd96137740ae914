#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_readings.h"

namespace fretval::benchmarks_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json json_of(const fs::path& file) {
  std::ifstream stream(file);
  return json::parse(stream);
}

void expect_same(const json& published, const json& today, const std::string& what) {
  ASSERT_EQ(published.is_null(), today.is_null()) << what;
  // Six digits are published.
  if (today.is_null()) return;
  EXPECT_NEAR(published.get<double>() / today.get<double>(), 1, 6e-6) << what;
}

// docs/benchmarks.json is made of what a run says; MDR's share is made again here.
TEST(Benchmarks, AreWhatMdrSaysToday) {
  const auto root = fs::path(FRETVAL_SOURCE_DIR);
  const auto published = json_of(root / "docs/benchmarks.json")["cases"];
  EXPECT_EQ(published.size(), 22U);
  for (const auto& one : published) {
    const auto name = one.at("name").get<std::string>();
    const auto file = root / "cases/benchmarks" / (name + ".json");
    EXPECT_EQ(one.at("input"), json_of(file)) << name;
    const auto scene = mdr_case(read_case_file(file).at(0));
    const json mdr = to_json(mdr_answer_with_cycle(scene, mdr_normal_response(scene)));
    for (const auto& [quantity, answer] : one.at("answer").items())
      expect_same(answer.at("mdr"), mdr.value(quantity, json()), name + " " + quantity);
  }
}

// Between six rounded digits, finite elements are within their bars and the error of MDR's springs.
TEST(Benchmarks, AreConfirmed) {
  int n_with_bar = 0;
  const auto published = json_of(fs::path(FRETVAL_SOURCE_DIR) / "docs/benchmarks.json")["cases"];
  for (const auto& one : published)
    for (const auto& [quantity, answer] : one.at("answer").items()) {
      if (answer.at("error_bar").is_null() || answer.at("mdr").is_null()) continue;
      const double mdr = answer["mdr"], fe = answer["fe"], bar = answer["error_bar"];
      EXPECT_LT(std::abs(fe - mdr), bar + answer.value("mdr_error", 0.0) + 1e-5 * mdr)
          << one.at("name") << " " << quantity;
      ++n_with_bar;
    }
  EXPECT_GT(n_with_bar, 80);
}

}  // namespace
}  // namespace fretval::benchmarks_test
