#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/stored_result.h"

namespace fretval::heading_test {
namespace {

StoredResult named(const std::string& name, const std::string& family) {
  auto json = stored_result();
  json["name"] = name;
  if (family.empty())
    json["scene"].erase("sweep");
  else
    json["scene"]["sweep"] = {{"family", family}, {"entry", "Motion / Phase"}, {"value", 30}};
  return {json, "/no/such/folder"};
}

TEST(Heading, IsTheNameOfTheCaseOrOfTheSweep) {
  EXPECT_EQ(heading_of({named("rig", "")}, {}, "").at("title"), "rig");
  EXPECT_EQ(heading_of({named("a/1", "a"), named("a/2", "a")}, {}, "").at("title"), "a: 2 cases over Motion / Phase");
  EXPECT_EQ(heading_of({named("a/1", "a"), named("b", "")}, {}, "").at("title"), "2 cases: a, b");
  EXPECT_EQ(heading_of({}, {}, "suites").at("title"), "suites");
  EXPECT_EQ(heading_of({named("rig", "")}, {}, "").at("date"), "") << "there is no file";
}

TEST(Heading, SaysWhatIsOfEarlierRuns) {
  const std::vector<StoredResult> results{named("new", ""), named("old", "")};
  EXPECT_FALSE(heading_of(results, {}, "").contains("earlier")) << "nobody knows";
  EXPECT_FALSE(heading_of(results, {"new", "old"}, "").contains("earlier"));
  const auto heading = heading_of(results, {"new"}, "");
  EXPECT_EQ(heading.at("earlier").at("count"), "1 result");
  EXPECT_EQ(heading.at("earlier").at("names"), "old");
}

// Of a stored result that is there.
TEST(Heading, HasTheDateOfTheNewestResult) {
  const ScratchFolder folder;
  folder.write("result.json", "{}");
  auto result = named("rig", "");
  result.folder = folder.path();
  const auto date = heading_of({result}, {}, "").at("date").get<std::string>();
  EXPECT_EQ(date.find(" 20"), date.size() - 5) << date;
}

TEST(Heading, SaysHowToCite) {
  const auto citation = heading_of({named("rig", "")}, {}, "").at("citation").get<std::string>();
  EXPECT_EQ(citation.rfind("The fretval authors, fretval ", 0), 0U) << citation;
}

}  // namespace
}  // namespace fretval::heading_test
