#include "mdr/support/column_choice.h"

#include <gtest/gtest.h>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::column_choice_test {
namespace {

const std::vector<WantedColumn> wanted{{{{"time", {"t"}, {{"s", 1}}}}},
                                       {{{"depth", {"d"}, {{"m", 1}}}, {"force", {"fn"}, {{"N", 1}}}}}};

Choices choices(const std::vector<std::string>& names, const std::vector<std::string>& units, InOrder in_order) {
  return choices_of(header_of(names, units, wanted), wanted, in_order, true);
}

TEST(ColumnChoice, GoesByNameThenByUnit) {
  const auto by_name = choices({"F_N", "t"}, {"N", "s"}, InOrder::no);
  EXPECT_EQ(by_name[0]->column, 1U);
  EXPECT_EQ(by_name[1]->column, 0U);
  EXPECT_EQ(by_name[1]->kind, 1U);
  const auto by_unit = choices({"a [m]", "b / s", "c"}, {}, InOrder::no);
  EXPECT_EQ(by_unit[0]->column, 1U);
  EXPECT_EQ(by_unit[1]->column, 0U);
  EXPECT_EQ(by_unit[1]->kind, 0U);
}

TEST(ColumnChoice, GoesByOrderWhereNothingHasAUnit) {
  EXPECT_EQ(choices({"a", "b"}, {}, InOrder::yes)[1]->column, 1U);
  EXPECT_NE(error_of([] {
              choices({"a", "b"}, {}, InOrder::no);
            }).find("has no column for the time, in s"),
            std::string::npos);
}

TEST(ColumnChoice, IsRefusedWhereItIsNotClear) {
  EXPECT_NE(error_of([] {
              choices({"t", "d", "F_N"}, {"s", "m", "N"}, InOrder::no);
            }).find("one alone can be prescribed"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              choices({"t", "a", "b"}, {"s", "m", "m"}, InOrder::no);
            }).find("is not clear: a [m] or b [m]"),
            std::string::npos);
}

TEST(ColumnChoice, SimplifiesNames) {
  EXPECT_EQ(simplified_name("E_stor [MPa]"), "estor");
  EXPECT_EQ(simplified_name("Storage-Modulus"), "storagemodulus");
  for (const char* loss : {"G\u2033", "G\u201d", "G\"", "G''", "G\u2032\u2032"})
    EXPECT_EQ(simplified_name(loss), "g''");
  EXPECT_EQ(simplified_name("G\u2032 (mean)"), "g'");
}

}  // namespace
}  // namespace fretval::mdr::column_choice_test
