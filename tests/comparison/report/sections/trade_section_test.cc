#include <gtest/gtest.h>

#include <filesystem>

#include "comparison/quantities/quantity.h"
#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

/// A text with single blanks.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' || result.empty() || result.back() != ' ') result += c;
  return result;
}

TEST(TradeText, AnswersWhatIsCheapestAndWhatEachAxisGives) {
  expect_parts(squeezed(trade_text(stored_trade())),
               {"\ncheapest for 1e-02 8 2 0.3 12 24 8.0e-03 0.25\n",
                "\nchosen by the tool for 1e-02 16 2 0.3 12 24 1.0e-03 0.5\n", "\nno setting of the plan meets 1e-04\n",
                "\nchosen by the tool for 1e-04, too coarse 16 ", "\nfront 8 ", "\nfront 16 ",
                "\nall dofs 8 2 0.3 12 24 8.0e-03 1.23e+03\n", "\n50 springs – – – – 45 – –\n",
                "\nclosed form – – – – – 0.0e+00 2.5e-05\n", "\nrings 8, 16 8.0e-03, 1.0e-03 -3.0\n"});
}

TEST(TradeSection, DrawsTheCostAndEachAxisOfMoreThanOneLevel) {
  const ScratchFolder folder;
  EXPECT_TRUE(trade_section(folder.path()).is_null());
  std::filesystem::create_directories(folder.path() / "case");
  folder.write("case/trade.json", stored_trade().dump());
  const auto section = trade_section(folder.path());
  expect_parts(section.dump(), {"Error over time", "Error over rings", "closed form: error 0"});
  EXPECT_EQ(section.dump().find("Error over order"), std::string::npos);
  const auto html = rendered(section);
  expect_parts(html, {"Speed and accuracy: case &lt;b&gt;", "<td class=\"bad-cell\">1.0e-03</td>"});
  EXPECT_GT(html.find("class=\"bad-cell\""), html.find("too coarse")) << "of the setting that meets its tolerance none";
}

TEST(TradeSection, DrawsTheErrorsOfEachQuantityAndTheClosedFormAlongTheFront) {
  const ScratchFolder folder;
  folder.write("trade.json", stored_trade().dump());
  const auto section = trade_section(folder.path());
  const auto& figures = section["trades"][0]["figures"]["figures"];
  ASSERT_EQ(figures.size(), 2U);
  const auto& cost = figures[0]["plot"];
  for (const auto& series : cost["series"]) {
    if (series["label"] != "closed form: error 0") continue;
    EXPECT_EQ(series["x"], nlohmann::ordered_json({2.5e-5, 2.5e-5}));
    EXPECT_EQ(series["y"], nlohmann::ordered_json({8e-3, 1e-3}));
  }
  const auto& rings = figures[1]["plot"];
  EXPECT_NEAR(rings["x_range"][0].get<double>(), 8 / 1.15, 1e-9);
  EXPECT_NEAR(rings["x_range"][1].get<double>(), 16 * 1.15, 1e-9);
  ASSERT_EQ(rings["series"].size(), 2U);
  for (const auto& series : rings["series"]) {
    const bool is_force = series["label"].get<std::string>() == traits_of(Quantity::normal_force_max).label;
    EXPECT_EQ(series["y"], is_force ? nlohmann::ordered_json({1e-4}) : nlohmann::ordered_json({8e-3, 1e-3}));
  }
}

TEST(TradeSection, EscapesTheNamesOfAxesAndRefusesADamagedFile) {
  const ScratchFolder folder;
  auto with_tag = stored_trade();
  with_tag["axes"]["<script>"] = with_tag["axes"]["order"];
  folder.write("trade.json", with_tag.dump());
  EXPECT_EQ(rendered(trade_section(folder.path())).find("<script"), std::string::npos);
  folder.write("trade.json", "{\"name\": 1}");
  expect_parts(refusal([&] { trade_section(folder.path()); }), {"trade.json: "});
}

}  // namespace
}  // namespace fretval
