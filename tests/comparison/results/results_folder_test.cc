#include "comparison/results/results_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(ResultsFolder, OfAnotherVersionIsRefused) {
  auto json = stored_result("phase");
  const ScratchFolder folder;
  json["schema"] = 1;
  folder.write("result.json", json.dump());
  EXPECT_EQ(read_results(folder.path()).size(), 1U);
  json["schema"] = 3;
  folder.write("result.json", json.dump());
  expect_parts(refusal([&] { read_results(folder.path()); }), {"the key \"schema\" is 3, must be 1 or 2"});
}

TEST(ResultsFolder, RefusesAResultOfAnotherKindByKey) {
  const auto good = stored_result();
  const ScratchFolder folder;
  const auto with = [&](const char* pointer, const nlohmann::ordered_json& value) {
    auto json = good;
    json[nlohmann::ordered_json::json_pointer(pointer)] = value;
    folder.write("result.json", json.dump());
    return refusal([&] { read_results(folder.path()); });
  };
  EXPECT_EQ(with("/name", "good"), "no error");
  expect_parts(with("/name", 1), {"result.json", "\"name\" is 1, must be text"});
  expect_parts(with("/pass", "yes"), {"\"pass\" is \"yes\", must be true or false"});
  expect_parts(with("/scene", nlohmann::ordered_json::array()), {"\"scene\" is array, must be an object"});
  expect_parts(with("/scene/sweep/value", nullptr), {"\"scene/sweep/value\" is null, must be a number"});
  expect_parts(with("/comparison/normal_force_max/difference", "1"), {"\"comparison/normal_force_max/difference\""});
  expect_parts(with("/cost/seconds/mesh", "1"), {"\"cost/seconds/mesh\"", "must be a number"});
  for (const char* key : {"dofs", "time_steps", "cycles"})
    expect_parts(with((std::string("/cost/") + key).c_str(), 1.2e12), {key, "at most 2e9"});
  expect_parts(with("/fe/error_estimate", 1), {"\"fe/error_estimate\" is 1, must be an object"});
  for (const char* wear : {"/fe/wear", "/fe/surface_wear"}) {
    expect_parts(with(wear, "unworn"), {wear + 1, "is \"unworn\", must be an object"});
    expect_parts(with(wear, {{"cycles", nlohmann::ordered_json::array()}, {"volume", {1e-15}}}),
                 {"/cycles\" is array, must be a list that is not empty"});
    expect_parts(with(wear, {{"cycles", {10}}, {"volume", 1e-15}}), {"/volume\" is 1e-15, must be a list"});
    EXPECT_EQ(with(wear, {{"cycles", {10}}, {"volume", {1e-15}}}), "no error");
  }
  expect_parts(with("/pass", std::string(61, 'x')), {"\"pass\" is string, must be"});
  expect_parts(with("/pass", std::string(60, 'x')), {"\"pass\" is \"xxx"});
  for (const char* key : {"name", "comparison"}) {
    auto without = good;
    without.erase(key);
    folder.write("result.json", without.dump());
    expect_parts(refusal([&] { read_results(folder.path()); }), {key, "\" is missing; is this a result of fretval?"});
  }
  folder.write("result.json", good.dump().substr(0, 300));
  expect_parts(refusal([&] { read_results(folder.path()); }), {"result.json", "parse error"});
  folder.write("result.json", "[]");
  expect_parts(refusal([&] { read_results(folder.path()); }), {"result.json", "no JSON object"});
}

TEST(ResultsFolder, IsReadByFamilyAndSweepValueFromAllFoldersBelow) {
  const ScratchFolder folder;
  const auto add = [&](const char* name, const char* family, int value) {
    auto json = stored_result();
    json["name"] = name;
    json["scene"]["sweep"]["family"] = family;
    json["scene"]["sweep"]["value"] = value;
    std::filesystem::create_directories(folder.path() / name);
    folder.write(std::string(name) + "/result.json", json.dump());
  };
  add("x/late", "first", 100);
  add("early", "first", 20);
  add("other", "second", 0);
  const auto results = read_results(folder.path());
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[0].sweep_value(), 20);
  EXPECT_EQ(results[1].folder, folder.path() / "x/late");
  EXPECT_EQ(results[2].family(), "second");
  EXPECT_TRUE(results[0].swept_over("Motion / Phase"));
  EXPECT_FALSE(results[0].swept_over("Wear / Stick radius ratio"));
  expect_parts(refusal([&] { read_results(folder.path() / "nowhere"); }), {"nowhere", "no such folder"});
}

TEST(ResultsFolder, IsReadByTheSecondValueOfASweepWithinTheFirst) {
  const ScratchFolder folder;
  for (const int k : {4, 0, 3, 1, 5, 2}) {
    auto json = stored_result();
    json["scene"]["sweep"] = {{"family", "f"},
                              {"entry", "Motion / Phase"},
                              {"value", k / 3},
                              {"second_entry", "Friction / Coefficient"},
                              {"second_value", 1 + k % 3}};
    const auto name = std::to_string((7 * k + 3) % 6);
    std::filesystem::create_directories(folder.path() / name);
    folder.write(name + "/result.json", json.dump());
  }
  const auto results = read_results(folder.path());
  ASSERT_EQ(results.size(), 6U);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(results[static_cast<std::size_t>(k)].sweep_value(), k / 3);
    EXPECT_EQ(results[static_cast<std::size_t>(k)].second_value(), 1 + k % 3);
  }
}

StoredResult with_scene(const nlohmann::ordered_json& more = nlohmann::ordered_json::object()) {
  auto json = stored_result();
  json["scene"].update(more);
  return {json, {}};
}

TEST(StoredResult, KnowsWhatKindOfMotionItIsOf) {
  EXPECT_TRUE(with_scene({{"frequency", 2}, {"tangential_frequency", 2}}).has_one_frequency());
  EXPECT_FALSE(with_scene({{"frequency", 2}, {"tangential_frequency", 3}}).has_one_frequency());
  for (const char* key : {"normal_harmonics", "tangential_harmonics"})
    EXPECT_FALSE(with_scene({{key, nlohmann::ordered_json::array()}}).has_one_frequency()) << key;
  EXPECT_FALSE(with_scene().has_forces());
  for (const char* key : {"normal_force_mean", "tangential_force_amplitude"})
    EXPECT_TRUE(with_scene({{key, 1}}).has_forces()) << key;
}

TEST(StoredResult, NamesItsCycle) {
  auto older = with_scene();
  older.json["scene"].erase("has_period");
  EXPECT_STREQ(older.cycle_name(), "period");
  EXPECT_STREQ(with_scene({{"has_period", false}}).cycle_name(), "near cycle");
  EXPECT_STREQ(with_scene({{"path", {{"repeats", "once"}}}}).cycle_name(), "pass");
}

// Nothing that is absent may look like a zero.
TEST(StoredResult, HasNoNumberWhereThereIsNone) {
  const StoredResult result{stored_result(), {}};
  EXPECT_EQ(result.number("scene", "tolerance"), 0.01);
  EXPECT_TRUE(std::isnan(result.number("fe", "worn_radius"))) << "null";
  EXPECT_TRUE(std::isnan(result.number("fe", "no such key")));
  EXPECT_TRUE(std::isnan(result.number("scene", "shape"))) << "text";
}

TEST(ReadColumns, TakesTheNamedOnesOrNone) {
  const ScratchFolder folder;
  const auto file = folder.write("table.csv", "r [m],p [Pa],u [m]\n1,2,3\n4e-3,5,6\n");
  const auto [radius, depth] = read_columns(file, "r [m]", "u [m]");
  EXPECT_EQ(radius, (std::vector<double>{1, 4e-3}));
  EXPECT_EQ(depth, (std::vector<double>{3, 6}));
  EXPECT_TRUE(read_columns(file, "r [m]", "tau [Pa]").first.empty());
  EXPECT_TRUE(read_columns(folder.path() / "none.csv", "r [m]", "u [m]").second.empty());
}

}  // namespace
}  // namespace fretval
