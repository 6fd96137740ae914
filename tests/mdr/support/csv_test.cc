#include "mdr/support/csv.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace fretval::mdr::csv_test {
namespace {

CsvColumns read(const std::string& text, std::size_t n_columns = 2) {
  std::istringstream stream(text);
  return read_csv(stream, "table.csv", n_columns);
}

// Text of the error, or "accepted".
std::string error_of(const std::string& text, std::size_t n_columns = 2) {
  try {
    read(text, n_columns);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

using Column = std::vector<double>;
using Names = std::vector<std::string>;

TEST(Csv, ReadsEverySeparator) {
  for (const std::string text : {"1,2.5\n-3,4e-3\n", "1;2.5\n-3;4e-3\n", "1\t2.5\n-3\t4e-3\n", "1  2.5\n -3 4e-3 \n",
                                 "1, 2.5\n-3 ,4e-3", "1 ;2.5\n-3; +4e-3", "1,\t2.5\n-3,\t4e-3\n"}) {
    const CsvColumns table = read(text);
    EXPECT_EQ(table.columns, (std::vector<Column>{{1, -3}, {2.5, 4e-3}})) << text;
    EXPECT_TRUE(table.names.empty() && table.units.empty());
  }
}

TEST(Csv, SkipsCommentsBlankLinesMarkAndLineEndings) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF";
    for (const char* line : {"# measured", "", "1,2 # first", "  \t", "3,4"}) text.append(line).append(end);
    const CsvColumns table = read(text);
    EXPECT_EQ(table.columns, (std::vector<Column>{{1, 3}, {2, 4}}));
    EXPECT_EQ(table.line_of_row, (std::vector<int>{3, 5}));
  }
}

TEST(Csv, KeepsNamesAndUnits) {
  const CsvColumns table = read(
      "\xEF\xBB\xBF"
      "f,E_stor,E_loss\nHz, MPa, MPa\n1,2,3\n",
      3);
  EXPECT_EQ(table.names, (Names{"f", "E_stor", "E_loss"}));
  EXPECT_EQ(table.units, (Names{"Hz", "MPa", "MPa"}));
  EXPECT_EQ(table.columns, (std::vector<Column>{{1}, {2}, {3}}));
  EXPECT_EQ(read("storage modulus, loss modulus\n1 2\n").names, (Names{"storage modulus", "loss modulus"}));
}

TEST(Csv, TakesOneForTheUnitOfARatio) {
  const CsvColumns table = read("f, G', tan delta\nHz, MPa, 1\n1, 2, 3\n", 3);
  EXPECT_EQ(table.units, (Names{"Hz", "MPa", "1"}));
  EXPECT_EQ(table.columns, (std::vector<Column>{{1}, {2}, {3}}));
  EXPECT_EQ(read("a,b\n1,1\n").columns, (std::vector<Column>{{1}, {1}}));
  EXPECT_EQ(read("a,b\nm,1\n1,1\n").columns, (std::vector<Column>{{1}, {1}}));
}

TEST(Csv, KeepsEveryDigit) {
  EXPECT_EQ(read("0.1 88.79651575665739").columns, (std::vector<Column>{{0.1}, {88.79651575665739}}));
}

TEST(Csv, TakesDecimalCommasBetweenSemicolonsAndTabs) {
  for (const std::string text : {"1;2,5\n-3;4e-3\n", "1\t2,5\n-3\t4e-3\n", "\"1\"; \"2,5\"\n-3; +4e-3\n"})
    EXPECT_EQ(read(text).columns, (std::vector<Column>{{1, -3}, {2.5, 4e-3}})) << text;
}

TEST(Csv, ErrorNamesSourceLineTextAndRemedy) {
  const std::string error = error_of("a,b\n1,2\n3,x4\n");
  for (const char* part : {"table.csv", "line 3", "3,x4", "\"x4\" is no number", "must be"}) {
    EXPECT_NE(error.find(part), std::string::npos) << part << " in: " << error;
  }
}

struct BadTable {
  const char* text;
  const char* named;
};

TEST(Csv, RejectsBadTables) {
  const BadTable tables[] = {
      {"1,2\n3\n", "line 2, \"3\": has 1 value; must have 2"},
      {"1,2\n3,4,5\n", "has 3 values; must have 2"},
      {"1,2,\n", "empty value"},
      {"1,,2\n", "empty value"},
      {"nan,1\n", "\"nan\" must be finite"},
      {"1,-Inf\n", "\"-Inf\" must be finite"},
      {"1,1e400\n", "\"1e400\" is beyond the range of double"},
      {"1,2\n3;4\n", "line 2, \"3;4\": has semicolons between its values, rows before have commas"},
      {"1 2\n3,4\n", "has commas between its values, rows before have blanks"},
      {"1e-4,1e-6\n4e-4;1,6e-5\n", "must be the same in all of the file"},
      {"1,5;2.5\n", "another decimal mark than values before"},
      {"1.000,5;2,5\n", "more than one decimal mark"},
      {"1,5 2,5\n", "decimal comma, which is not accepted"},
      {"1,5,2,5\n", "decimal commas are not accepted"},
      {"1,0x10\n", "\"0x10\" is no number"},
      {"1,2e\n", "\"2e\" is no number"},
      {"1,+-2\n", "\"+-2\" is no number"},
      {"f,g\n1,1..2\n", "\"1..2\" is no number"},
      {"f,1\n", "\"f\" is no number"},
      {"", "has no rows; must have rows of 2 numbers"},
      {"f,g\n#1,2\n", "has no rows"},
      {"frequency\n1,2\n", "must have 2 names or units, or begin with #"},
      {"f,g\nHz,Pa\nx,y\n", "line 3"},
      {"1,2\nf,g\n", "a header must precede the rows"},
  };
  for (const BadTable& table : tables) {
    EXPECT_NE(error_of(table.text).find(table.named), std::string::npos) << table.text << error_of(table.text);
  }
}

TEST(Csv, RejectsBinaryContent) {
  EXPECT_NE(error_of(std::string("1,2\n3,\0004\n", 9)).find("line 2"), std::string::npos);
  EXPECT_NE(error_of(std::string("1,2\n3,\0004\n", 9)).find("zero byte"), std::string::npos);
}

TEST(Csv, RejectsTooMuch) {
  EXPECT_NE(error_of(std::string(20'000, '1'), 1).find("at most 10000 characters"), std::string::npos);
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) text += "1\n";
  EXPECT_EQ(error_of(text, 1), "accepted");
  EXPECT_NE(error_of(text + "1\n", 1).find("at most a million rows"), std::string::npos);
}

TEST(Csv, RejectsBadStreamAndNoColumns) {
  std::istringstream stream("1");
  EXPECT_THROW(read_csv(stream, "table.csv", 0), std::invalid_argument);
  stream.setstate(std::ios::failbit);
  EXPECT_THROW(read_csv(stream, "table.csv", 1), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::csv_test
