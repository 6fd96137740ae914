#include "comparison/case_file/entry_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>

namespace fretval::entry_table_test {
namespace {

TEST(EntryTable, NamesEverySectionAndEntryOnceAndSaysWhatItIs) {
  std::set<std::string> sections;
  for (const auto& section : case_sections()) {
    EXPECT_TRUE(sections.insert(section.name).second) << section.name;
    std::set<std::string> entries;
    for (const auto& entry : section.entries) {
      EXPECT_TRUE(entries.insert(entry.name).second) << section.name << " / " << entry.name;
      for (const auto& text : {entry.values.text, std::string(entry.without), std::string(entry.about)})
        EXPECT_FALSE(text.empty()) << section.name << " / " << entry.name;
    }
  }
}

// The reference of the entries says what is accepted: "0.5 to 20" is refused a little below and above.
TEST(EntryTable, SaysOfRangesWhatIsAccepted) {
  int n_ranges = 0;
  for (const auto& section : case_sections())
    for (const auto& entry : section.entries) {
      const auto& [text, number, words] = entry.values;
      std::smatch range;
      if (!number || !std::regex_search(text, range, std::regex("([0-9.e-]+) to ([0-9.e-]+)"))) continue;
      ++n_ranges;
      const double least = std::stod(range[1]), most = std::stod(range[2]), whole = least >= 1 ? 1 : 1e-9;
      const auto name = std::string(section.name) + " / " + entry.name;
      for (const double inside : {least + whole, std::floor((least + most) / 2) + (most < 2 ? most / 2 : 0)})
        EXPECT_TRUE(number->accepts(inside)) << name << ": " << inside;
      for (const double outside : {least - whole, most + whole}) EXPECT_FALSE(number->accepts(outside)) << name;
    }
  EXPECT_GE(n_ranges, 9);
}

TEST(EntryTable, LetsEntriesBelongToWordsOfTheFirstOfTheirSection) {
  for (const auto& section : case_sections())
    for (const auto& entry : section.entries)
      for (const auto& owner : entry.owners) {
        const auto& words = section.entries.front().values.words;
        EXPECT_NE(std::find(words.begin(), words.end(), owner), words.end()) << section.name << " / " << entry.name;
      }
  const auto& flat_radius = case_sections().front().entries[5];
  ASSERT_STREQ(flat_radius.name, "Flat radius");
  EXPECT_TRUE(flat_radius.belongs_to("rounded flat"));
  EXPECT_FALSE(flat_radius.belongs_to("cone"));
}

}  // namespace
}  // namespace fretval::entry_table_test
