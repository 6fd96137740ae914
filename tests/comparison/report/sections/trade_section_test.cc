#include <gtest/gtest.h>

#include <filesystem>

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
  expect_parts(rendered(section), {"Speed and accuracy: case &lt;b&gt;", "<td class=\"bad-cell\">1.0e-03</td>"});
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
