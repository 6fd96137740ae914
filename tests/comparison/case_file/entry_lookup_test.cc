#include "comparison/case_file/entry_lookup.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"

namespace fretval::entry_lookup_test {
namespace {

TEST(EntryLookup, EntriesBelongToTheirSection) {
  EXPECT_TRUE(is_entry("Friction", "Coefficient"));
  EXPECT_TRUE(is_entry("Wear", "Coefficient"));
  EXPECT_FALSE(is_entry("Friction", "Radius"));
  EXPECT_FALSE(is_entry("Friction", "coefficient"));
  EXPECT_FALSE(is_entry("Fiction", "Coefficient"));
  EXPECT_TRUE(find_section("Wear"));
  EXPECT_FALSE(find_section("wear"));
  expect_parts(valid_entries(),
               {"Indenter: Shape, Radius, ", "; Friction: Coefficient, Law; ", "Sweep: Entry, Values"});
}

TEST(EntryLookup, TakesPlacesApart) {
  const auto [section, entry] = place_of("Body / Poisson / ratio");
  EXPECT_EQ(section, "Body");
  EXPECT_EQ(entry, "Poisson / ratio");
  EXPECT_EQ(place_of("Body").section, "Body");
  EXPECT_EQ(find_entry("Body"), nullptr);
  EXPECT_EQ(find_entry("Friction / Coefficient"), find_entry("Friction", "Coefficient"));
}

TEST(EntryLookup, MeasuresWhatTheEntryIsAbout) {
  EXPECT_EQ(find_entry("Friction", "Coefficient")->dimensions, std::vector{Dimension::number});
  EXPECT_EQ(find_entry("Wear", "Coefficient")->dimensions, std::vector{Dimension::wear_rate});
  EXPECT_EQ(find_entry("Indenter", "Coefficient")->dimensions, std::vector{Dimension::varying});
  EXPECT_TRUE(find_entry("Indenter", "Shape")->dimensions.empty());
  EXPECT_EQ(find_entry("Indenter", "Mass"), nullptr);
}

TEST(EntryLookup, WhatWasMeantIsSaidAndNotMissingAsWell) {
  Problems problems;
  expect_parts(no_such_section("Motoin", problems),
               {"subsection Motoin", "did you mean Motion? Valid subsections: Indenter, "});
  expect_parts(no_such_entry("Indenter", "Radios", problems), {"did you mean Radius?", "Valid entries of Indenter: "});
  EXPECT_EQ(problems.meant.count("Motion"), 1U);
  EXPECT_EQ(problems.meant.count("Indenter / Radius"), 1U);
  expect_parts(no_such_entry("Elastomer", "Poisson's ratio", problems),
               {"Poisson ratio = 0.49", "1/2 where it is not set"});
  expect_parts(no_such_entry("Elastomer", "Young's modulus", problems), {"Relaxed shear modulus = E/3"});
  expect_parts(no_such_entry("Friction", "Phase", problems), {"did you mean Motion / Phase?"});
}

// "Base" of the section Body has fewer letters wrong.
TEST(EntryLookup, PrefersTheEntriesOfTheSection) {
  Problems problems;
  expect_parts(no_such_entry("Motion", "Fase", problems), {"Motion / Fase: no such entry; did you mean Phase? "});
  EXPECT_EQ(problems.meant.count("Motion / Phase"), 1U);
  expect_parts(no_such_entry("Motion", "Radius", problems), {"did you mean Indenter / Radius or Body / Radius?"});
}

TEST(EntryLookup, IsWrittenAsAPage) {
  expect_parts(entries_reference(), {"## Motion\n\n| entry | values | unit |", "| Indentation | positive | m |",
                                     "| Normal harmonics | triples, a list | m, Hz, deg |"});
}

TEST(Problems, AreThrownTogetherEachOnce) {
  Problems problems;
  EXPECT_NO_THROW(problems.throw_if_any());
  problems.add("one");
  problems.add("two");
  problems.add("one");
  EXPECT_EQ(refusal([&] { problems.throw_if_any(); }), "one\ntwo");
}

}  // namespace
}  // namespace fretval::entry_lookup_test
