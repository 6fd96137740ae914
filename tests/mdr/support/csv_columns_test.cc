#include "mdr/support/csv_columns.h"

#include <gtest/gtest.h>

#include <sstream>

#include "mdr/support/csv_units.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::csv_columns_test {
namespace {

const std::vector<WantedColumn> wanted{
    {{{"frequency", {"f", "freq*"}, {{"Hz", 1}, {"rad/s", 0.5}}}}},
    {{{"storage modulus", {"g'", "stor*", "gstor"}, modulus_units()}}},
    {{{"loss modulus", {"g''", "loss"}, modulus_units()}, {"loss factor", {"tan*"}, ratio_units()}}, false, true}};

ChosenColumns read(const std::string& text, InOrder in_order = InOrder::yes) {
  std::istringstream stream(text);
  return read_columns(stream, "dma.csv", wanted, in_order);
}

using Columns = std::vector<std::vector<double>>;
const Columns expected{{0.5, 2}, {1.25, 3}, {0.25, 1}};

TEST(CsvColumns, AreTheSameInEveryDialect) {
  for (const std::string text :
       {"f,G',G''\nHz,MPa,MPa\n0.5,1.25,0.25\n2,3,1\n",                                      // as it was
        "f;G';G''\nHz;MPa;MPa\n0,5;1,25;0,25\n2;3;1\n",                                      // half of Europe
        "f [Hz];G' [MPa];G\" [MPa]\r\n5,0E-1;1,25;0,25\r\n2;3;1\r\n",                        // and Windows
        "f\tG'\tG''\nHz\tMPa\tMPa\n0,5\t1,25\t0,25\n2\t3\t1\n",                              // tabs
        "\xEF\xBB\xBF\"f\",\"G'\",\"G''\"\n\"Hz\",\"MPa\",\"MPa\"\n0.5,1.25,0.25\n2,3,1\n",  // quoted
        "G'' / MPa;f / Hz;G' / MPa\n0,25;0,5;1,25\n1;2;3\n",                                 // any order, strokes
        "T [\xB0"
        "C];Freq [Hz];G_stor [MPa];loss [MPa];set\n20;0,5;1,25;0,25;A\n20;2;3;1;B 2\n",      // more columns
        "Sample;12\nDate;3.4.2021\n\nf [Hz];G' [MPa];G'' [MPa];\n0,5;1,25;0,25;\n2;3;1;\n",  // lines ahead, empty end
        "Sample;7;3\nf [Hz];G' [MPa];G'' [MPa]\n0,5;1,25;0,25\n2;3;1\n",                     // names are no units
        "# f G' G''\n# Hz MPa MPa\n0.5 1.25 0.25\n2 3 1\n",                                  // behind a comment sign
        "a [Hz],b [MPa],c [MPa]\n0.5,1.25,0.25\n2,3,1\n"}) {                                 // told by units
    const auto chosen = read(text);
    EXPECT_EQ(chosen.csv.columns, expected) << text;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(names_unit(chosen.csv, k)) << text;
  }
}

TEST(CsvColumns, OfOneUnitAreToldByTheirNames) {
  EXPECT_EQ(read("loss [MPa],storage [MPa],f [Hz]\n0.25,1.25,0.5\n1,3,2\n").csv.columns, expected);
  const auto chosen = read("tan(delta);G' [MPa];f [Hz]\n0,25;1,25;0,5\n1;3;2\n");
  EXPECT_EQ(chosen.csv.columns, expected);
  EXPECT_EQ(chosen.kind[2], std::optional<std::size_t>(1));
}

TEST(CsvColumns, SayWhatIsSkipped) {
  EXPECT_EQ(read("f,G',G''\nHz,MPa,MPa\n0.5,1.25,0.25\n").skipped, "");
  EXPECT_EQ(read("x\ny;1\nT;f [Hz];G' [MPa];G'' [MPa];set\n1;0,5;1,25;0,25;A\n").skipped,
            "2 lines ahead of the columns, columns T, set");
}

TEST(CsvColumns, OfThousandsOfLinesAheadAreFound) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "Parameter " + std::to_string(i) + ";1,5;on;off\n";
  const auto chosen = read(text + "f [Hz];G' [MPa];G'' [MPa]\n0,5;1,25;0,25\n2;3;1\n");
  EXPECT_EQ(chosen.csv.columns, expected);
  EXPECT_EQ(chosen.csv.line_of_row, (std::vector<int>{5002, 5003}));
}

TEST(CsvColumns, WithoutNamesAreTakenInTheirOrder) {
  EXPECT_EQ(read("0.5 1.25 0.25\n2 3 1\n").csv.columns, expected);
  EXPECT_EQ(read("a,b,c\n0.5,1.25,0.25\n2,3,1\n").csv.columns, expected);
}

struct BadTable {
  const char* text;
  const char* named;
};

TEST(CsvColumns, RefuseWhatIsNotClear) {
  const BadTable tables[] = {
      {"f [Hz];G' [MPa];G'' [MPa]\n0,5;1.25;0,25\n", "another decimal mark"},
      {"f [Hz];G' [MPa];G'' [MPa]\n0,5;1.250,5;0,25\n", "more than one decimal mark"},
      {"f [Hz];x [MPa];y [MPa];z [MPa]\n1;2;3;4\n", "is not clear: x [MPa] or y [MPa]"},
      {"f [Hz];freq [Hz];G' [MPa];G'' [MPa]\n1;2;3;4\n", "which column is the frequency is not clear"},
      {"T [K];G' [MPa];G'' [MPa]\n1;2;3\n", "has no column for the frequency"},
      {"log f [Hz];G' [MPa];G'' [MPa]\n1;2;3\n", "has no column for the frequency"},
      {"f [Hz];G' [MPa];G'' [MPa]\n1;2;x\n2;3;4\n", "no"},
      {"f [Hz];G' [MPa];G'' [MPa]\n1;2;3\n1;2\n", "line 3"},
      {"f [Hz];G' [MPa];G'' [MPa]\n1;2;3\n1;;3\n", "has an empty value"},
      {"f [Hz];G' [MPa];G'' [MPa]\n1;2;3\n1;2;3;4\n", "has 4 values; must have 3"},
  };
  for (const auto& [text, named] : tables)
    EXPECT_NE(error_of([&, text = text] { read(text); }).find(named), std::string::npos)
        << text << error_of([&, text = text] { read(text); });
  EXPECT_NE(error_of([] { read("a [Hz],b [MPa],c [MPa]\n1,2,3\n", InOrder::no); }).find("is not clear"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::csv_columns_test
