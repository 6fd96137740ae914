#include "comparison/case_file/entry_table.h"

#include <gtest/gtest.h>

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
      for (const std::string text : {entry.values, entry.without, entry.about})
        EXPECT_FALSE(text.empty()) << section.name << " / " << entry.name;
    }
  }
}

}  // namespace
}  // namespace fretval::entry_table_test
