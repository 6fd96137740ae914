#include "comparison/report/drawing/plots.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/browser.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval::plots_test {
namespace {

TEST(Plots, AreDataOfThePage) {
  Plot plot{"title", "x", "y"};
  plot.series.push_back({"curve", {1, 2}, {std::nan(""), 1.23456789}, Series::Style::open_points, 3, {0, 0.25}});
  plot.marks = {{"c", 1.5}};
  plot.x_range = {0, 4};
  EXPECT_EQ(json_of(plot).dump(),
            R"({"title":"title","x_label":"x","y_label":"y","log_x":false,"log_y":false,"x_range":[0.0,4.0],)"
            R"("marks":[{"name":"c","x":1.5}],"series":[{"label":"curve","style":"open points","colour":3,)"
            R"("x":[1.0,2.0],"y":[null,1.23457],"bar":[0.0,0.25]}]})");
}

Plot two_curves() {
  Plot plot{"Shakedown of <b>c_{FE}</b> & c", "phase φ_0", "c / a"};
  plot.series = {{"MDR, k_1", {0, 1, 2}, {1, 2, 3}},
                 {"", {0, 1, 2}, {1, 2, 3}, Series::Style::points, 0, {0.25, std::nan(""), 0.5}},
                 {"left out", {0, 2}, {1, 1}, Series::Style::dashed, 1}};
  plot.marks = {{"a", 1.5}, {"outside", 5}};
  plot.x_range = {0, 4};
  return plot;
}

/// A page with these plots alone, as a browser draws them.
class PlotsSlow : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  }

  /// What a script finds, which leaves it in `found`. The page may be a dark one.
  [[nodiscard]] nlohmann::json found(const std::vector<Filling>& plots, const std::string& script,
                                     bool dark = false) const {
    Filling figures{{"template", "figures"}, {"figures", Filling::array()}};
    for (const auto& plot : plots) figures["figures"].push_back({{"plot", plot}, {"caption", ""}});
    auto page = page_with(figures);
    if (dark) page = replace(page, "(prefers-color-scheme: dark)", "(min-width: 1px)");
    page += "<script>(async () => { let found; " + script +
            " document.body.dataset.found = JSON.stringify(found); })();</script>";
    return found_in(browsed(folder_.write("page.html", page), "--dump-dom", folder_), "found");
  }

  ScratchFolder folder_;
};

// What an axis cannot show leaves a gap; a plot of gaps alone says so.
TEST_F(PlotsSlow, WithoutPointsSaySo) {
  const double none = std::nan("");
  std::vector<Filling> plots;
  const auto add = [&](bool log_x, bool log_y, std::vector<double> x, std::vector<double> y) {
    Plot plot{"a", "x", "y", {{"curve", std::move(x), std::move(y)}}};
    plot.log_x = log_x;
    plot.log_y = log_y;
    plots.push_back(json_of(plot));
  };
  add(false, false, {}, {});
  add(false, false, {none, 1}, {1, none});
  add(false, false, {-1, 1}, {-1, 1});
  add(false, true, {1, 2}, {0, -1});
  add(false, true, {-1, 2}, {1, 10});
  add(true, true, {-1, 0}, {1, 1});
  add(true, true, {-1, 1, 10}, {1, 1, none});
  EXPECT_EQ(found(plots,
                  "found = [...document.querySelectorAll('svg.canvas')].map((svg) => [...svg.querySelectorAll('text')]"
                  ".some((text) => text.textContent === 'no data'));")
                .dump(),
            "[true,true,false,true,false,true,false]");
}

// Of half a decade, of one, of a few and of fourteen, on either axis: two labels at least, and none upon another.
TEST_F(PlotsSlow, LabelsOfLogarithmicAxesDoNotOverlap) {
  std::vector<Filling> plots;
  for (const auto& [least, most] : {std::pair{1.1, 3.4}, std::pair{2e-4, 2e-3}, std::pair{0.3, 40.0},
                                    std::pair{1e-5, 2e-1}, std::pair{1e-9, 1e5}}) {
    Plot plot{"a", "x", "y", {{"curve", {least, most}, {least, most}}}};
    plot.log_x = plot.log_y = true;
    plots.push_back(json_of(plot));
  }
  const auto at = found(plots, R"(
    const meets = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    found = {overlaps: 0, fewest: 99, axes: 0};
    for (const axis of new Set([...document.querySelectorAll("svg.canvas .tick")].map((tick) => tick.parentNode))) {
      const boxes = [...axis.querySelectorAll(".tick text")].map((text) => text.getBoundingClientRect())
        .filter((box) => box.width > 0);
      found.axes += 1;
      found.fewest = Math.min(found.fewest, boxes.length);
      boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b) => { found.overlaps += meets(a, b); }));
    })");
  EXPECT_EQ(at.at("axes"), 10);
  EXPECT_EQ(at.at("overlaps"), 0);
  EXPECT_GE(at.at("fewest"), 2);
}

/// Boxes of the areas of a colour, from left to right.
const std::string boxes =
    "const boxes = (colour) => [...document.querySelectorAll(`svg.canvas rect[fill=\"var(--${colour})\"]`)]"
    ".map((rect) => rect.getBBox()).filter((box) => box.width > 0).sort((a, b) => a.x - b.x);";

TEST_F(PlotsSlow, BarsGoBothWaysFromWhereTheyStart) {
  const auto bars = share_bars("t", "x", {"more", "less"}, {{"a", {4, 0}}, {"b", {0, -6}, 4, 0.05}}, 0, "%");
  const auto at = found({bars}, boxes + R"(
    const [more] = boxes("c0"), [less] = boxes("c1");
    const limit = +document.querySelector("svg.canvas line[stroke-dasharray]").getAttribute("x1");
    const bar = document.querySelector("svg.canvas line[stroke-width='2']");
    found = {zero: more.x - limit, ratio: less.width / more.width, ends: less.x + less.width - more.x - more.width,
             bar: (+bar.getAttribute("x1") + +bar.getAttribute("x2")) / 2 - less.x,
             length: (bar.getAttribute("x2") - bar.getAttribute("x1")) / more.width};)");
  constexpr double pixel = 1e-3;
  EXPECT_NEAR(at.at("zero"), 0, pixel);
  EXPECT_NEAR(at.at("ratio"), 1.5, pixel);
  EXPECT_NEAR(at.at("ends"), 0, pixel);
  EXPECT_NEAR(at.at("bar"), 0, pixel);
  EXPECT_NEAR(at.at("length"), 0.025, pixel);
}

// Rings of equal zones are one rectangle, open ones none; the first zone of the first step is two rings high.
TEST_F(PlotsSlow, ZonesAreARectangleAStep) {
  auto map = zone_map("a < b", "r / a_0", {0.5, 1, 1.5}, {"ssf", "sbo"});
  map["marks"] = {{{"name", "c"}, {"x", 0.75}}};
  const auto at = found({map}, boxes + R"(
    const [first, second] = boxes("sticks"), mark = document.querySelector("svg.canvas line[stroke-dasharray]");
    found = {n: ["sticks", "forward", "backward"].map((zone) => boxes(zone).length), ratio: first.height / second.height,
             mark: (first.y + first.height - mark.getAttribute("y1")) / first.height};)");
  EXPECT_EQ(at.at("n").dump(), "[2,1,1]");
  constexpr double pixel = 1e-3;
  EXPECT_NEAR(at.at("ratio"), 2, pixel);
  EXPECT_NEAR(at.at("mark"), 0.75, pixel);
}

// The button saves what is shown as a drawing that needs neither the page nor its style, light on a dark page as well.
TEST_F(PlotsSlow, AreSavedAsDrawingsOfTheirOwn) {
  auto map = zone_map("zones", "r", {0.5, 1}, {"ss", "sb"});
  const std::vector<Filling> plots{json_of(two_curves()), map, share_bars("budget", "x", {"rings"}, {{"a", {4}}})};
  const std::string save = R"(
    const files = [];
    URL.createObjectURL = (file) => { files.push(file); return "#"; };
    const before = document.querySelector("svg.canvas").getAttribute("viewBox");
    [...document.querySelectorAll(".legend button")].pop().click();
    const buttons = [...document.querySelectorAll(".tools button")].filter((button) => button.textContent === "SVG");
    buttons.forEach((button) => button.click());
    const texts = await Promise.all(files.map((file) => file.text()));
    const drawn = async (text) => {
      const image = new Image();
      image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text);
      await image.decode();
      const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
      [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
      context.drawImage(image, 0, 0);
      const {data} = context.getImageData(0, 0, canvas.width, canvas.height);
      return {size: [canvas.width, canvas.height], corner: [...data.slice(0, 4)],
              inked: data.filter((v, i) => i % 4 === 0 && v < 250).length};
    };
    found = {names: buttons.map((button) => button.getAttribute("aria-label")), kept: before === document.querySelector("svg.canvas").getAttribute("viewBox"),
             files: await Promise.all(texts.map(async (text) => {
      const svg = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
      return {root: svg.tagName, words: [...svg.querySelectorAll("text")].map((node) => node.textContent), title: svg.querySelector("title").textContent,
              of_page: (text.match(/var\(|class=|style=|tabindex/g) || []).length, paths: svg.querySelectorAll("path").length, ...(await drawn(text))};
    }))};)";
  const auto light = found(plots, save), dark = found(plots, save, true);
  EXPECT_EQ(light.at("names").at(0), "save Shakedown of <b>cFE</b> & c as SVG");
  EXPECT_EQ(light.at("kept"), true);
  ASSERT_EQ(light.at("files").size(), 3U);
  for (const auto& file : light["files"]) {
    EXPECT_EQ(file.at("root"), "svg");
    EXPECT_EQ(file.at("of_page"), 0);
    EXPECT_EQ(file.at("size").at(0), 640);
    EXPECT_EQ(file.at("corner").dump(), "[255,255,255,255]");
    EXPECT_GT(file.at("inked"), 1000);
  }
  const auto words = light["files"][0].at("words").dump();
  for (const char* part : {"\"Shakedown of <b>cFE</b> & c\"", "\"MDR, k1\"", "\"phase φ0\"", "\"c / a\"", "\"a\""})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
  for (const char* part : {"left out", "outside"}) EXPECT_EQ(words.find(part), std::string::npos) << words;
  EXPECT_EQ(light["files"][0].at("title"), "Shakedown of <b>cFE</b> & c: c / a over phase φ0");
  EXPECT_NE(light["files"][1].at("words").dump().find("slips backward"), std::string::npos);
  EXPECT_NE(light["files"][2].at("words").dump().find("rings"), std::string::npos);
  EXPECT_EQ(dark.at("files"), light.at("files"));
}

Filling two_rows() {
  return share_bars("Error <budget>", "over the tolerance", {"rings", "time step"},
                    {{"first slip", {0.25, 0.5}}, {"force", {0, 0.125}}});
}

TEST(ShareBars, AreDataOfThePage) {
  EXPECT_EQ(two_rows().dump(),
            R"({"kind":"bars","title":"Error <budget>","x_label":"over the tolerance","sources":["rings","time step"],)"
            R"("of_what":"of the tolerance","limit":1.0,)"
            R"("rows":[{"label":"first slip","shares":[0.25,0.5],"start":0.0,"bar":0.0},)"
            R"({"label":"force","shares":[0.0,0.125],"start":0.0,"bar":0.0}]})");
}

TEST(ZoneMap, IsDataOfThePage) {
  EXPECT_EQ(zone_map("a < b", "r", {0.5, 1}, {"sf", "bo"}).dump(),
            R"({"kind":"map","title":"a < b","x_label":"time over the period","y_label":"r","edges":[0.5,1.0],)"
            R"("zones":["sf","bo"]})");
}

TEST(ZoneMap, HasTheOuterEdgesOfRings) {
  const auto edges = outer_edges({std::sqrt(0.5), std::sqrt(2.5), std::sqrt(6.5)}, 2);
  ASSERT_EQ(edges.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(edges[i], 0.5 * static_cast<double>(i + 1), 1e-15);
}

TEST(Plots, KnowWhichAxisIsLogarithmic) {
  Plot plot{"title", "x", "y"};
  plot.log_x = true;
  EXPECT_EQ(json_of(plot)["log_x"], true);
  EXPECT_EQ(json_of(plot)["log_y"], false);
}

TEST(Axis, HasThePrefixOfTheLargestValue) {
  const std::vector<double> small{1e-6, -2e-3, std::nan(""), HUGE_VAL}, nothing{0};
  const auto axis = axis_for({&small, &nothing}, "m");
  EXPECT_EQ(axis.unit, "mm");
  EXPECT_NEAR(axis.of(small)[1], -2, 1e-15);
  EXPECT_EQ(axis_for({&nothing}, "N").unit, "N");
}

TEST(Axis, MarksTheRadiiThatThereAre) {
  StoredResult result{stored_result(), {}};
  result.json["scene"]["contact_radius_unworn"] = 2;
  result.json["fe"]["stick_radius_shakedown"] = 0.5;
  const auto marks = radius_marks(result, {"mm", 1e-3});
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0], (std::pair<std::string, double>("c", 500)));
  EXPECT_EQ(marks[1], (std::pair<std::string, double>("a", 2000)));
  result.json["fe"]["stick_radius_shakedown"] = nullptr;
  EXPECT_EQ(radius_marks(result, {"m", 1}).size(), 1U);
}

}  // namespace
}  // namespace fretval::plots_test
