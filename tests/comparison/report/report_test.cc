#include "comparison/report/report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "comparison/command_line/ending.h"
#include "comparison/verification/suite.h"
#include "tests/comparison/browser.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// The report of results, each in a folder of its own, as its script shows it.
std::string page_of(const std::vector<nlohmann::ordered_json>& results) {
  const ScratchFolder folder;
  for (std::size_t i = 0; i < results.size(); ++i) {
    fs::create_directories(folder.path() / std::to_string(i));
    folder.write(std::to_string(i) + "/result.json", results[i].dump());
  }
  return shown(text_of(write_report(folder.path())));
}

const std::string heading = "Does only the modulus ratio matter?";

TEST(Report, ComparesRheologiesByTheirLargestDifferences) {
  auto solid = stored_result(), other_phase = stored_result(), creeping = stored_result();
  solid["comparison"]["stick_radius_shakedown"]["difference"] = 1.25e-4;
  other_phase["scene"]["sweep"]["value"] = 90;
  other_phase["comparison"]["stick_radius_shakedown"]["difference"] = -3.5e-4;
  other_phase["cost"]["cycles"] = 77;
  creeping["scene"]["rheology"] = "Kelvin-Voigt";
  creeping["mdr"]["modulus_ratio"] = 1.5;
  creeping["comparison"]["stick_radius_first_slip"]["difference"] = 6.5e-4;
  creeping["comparison"]["stick_radius_shakedown"]["difference"] = 7.5e-5;
  creeping["cost"]["cycles"] = 123;
  EXPECT_EQ(page_of({solid, other_phase}).find(heading), std::string::npos) << "one rheology compares with nothing";
  const auto page = page_of({solid, other_phase, creeping});
  const auto section = page.substr(std::min(page.find(heading), page.size()));
  expect_parts(section, {"<td>Kelvin-Voigt</td><td>1.500000</td><td>1</td><td>6.5e-04</td><td>7.5e-05</td>"
                         "<td>up to 123</td>",
                         "<td>standard solid</td><td>1.359827</td><td>2</td>", "<td>3.5e-04</td><td>up to 77</td>"});
}

// Cases under forces do not stand beside those under displacements.
TEST(Report, ComparesRheologiesUnderDisplacementsByTheMostCycles) {
  auto solid = stored_result(), other_phase = stored_result(), creeping = stored_result();
  solid["cost"]["cycles"] = 90;
  other_phase["scene"]["sweep"]["value"] = 90;
  other_phase["cost"]["cycles"] = 50;
  creeping["scene"]["rheology"] = "Kelvin-Voigt";
  const auto page = page_of({solid, other_phase, creeping});
  expect_parts(page.substr(std::min(page.find(heading), page.size())), {"<td>up to 90</td>"});
  creeping["scene"]["tangential_force_amplitude"] = 0.5;
  EXPECT_EQ(page_of({solid, other_phase, creeping}).find(heading), std::string::npos);
}

// Over a = 2 m: 1.5 m is 0.1 a from 1.3 m and 0.5 a from 0.5 m, and 1 m is 0.25 a from 0.5 m.
TEST(Report, HoldsTheZoneThatHasNeverSlippedToTheFirstSlipRadius) {
  auto json = stored_result();
  json["scene"]["contact_radius_unworn"] = 2;
  json["mdr"]["stick_radius_first_slip"] = 0.5;
  json["mdr"]["stick_radius_shakedown"] = 1.3;
  json["fe"]["stick_radius_first_slip"] = 1;
  json["fe"]["stick_radius_shakedown"] = 1.5;
  expect_parts(page_of({json}), {"at most 1.0e-01 a away from the shakedown radius", "up to 0.50 a away",
                                 "within 2.5e-01 a of the first-slip radius"});
}

TEST(Report, SaysWhichStickRadiusTheSteadyStateFollows) {
  const auto as_stored = stored_result();
  expect_parts(page_of({as_stored}), {"it follows the shakedown radius", "Over 1 case with"});
  auto equal = stored_result();
  for (const char* side : {"fe", "mdr"})
    equal[side]["stick_radius_first_slip"] = equal[side]["stick_radius_shakedown"] = 0.0008;
  expect_parts(page_of({equal}), {"it does not single out the shakedown radius"});
  auto never = stored_result();
  never["mdr"]["stick_radius_first_slip"] = nullptr;
  expect_parts(page_of({never}), {"In 1 case the first-slip criterion says that nothing sticks"});
  auto nothing = stored_result();
  for (const char* side : {"fe", "mdr"}) nothing[side]["stick_radius_shakedown"] = nullptr;
  EXPECT_EQ(page_of({nothing}).find("Which stick radius do finite elements follow?"), std::string::npos);
}

// What a sweep is about comes before its numbers.
TEST(Report, ShowsTheCurvesOfASweepBeforeItsValues) {
  std::vector<nlohmann::ordered_json> results(2, stored_result());
  for (std::size_t i = 0; i < 2; ++i) {
    results[i]["name"] = "mu/" + std::to_string(i);
    results[i]["scene"]["sweep"] = {{"family", "mu"}, {"entry", "Friction / Coefficient"}, {"value", 0.5 + 0.1 * i}};
  }
  const auto page = page_of(results);
  const auto curves = page.find("mu: over Friction / Coefficient"), values = page.find("table: the values of both");
  EXPECT_NE(curves, std::string::npos);
  EXPECT_LT(curves, values);
}

// The figures of the paper: other shapes stand in the tables alone.
TEST(Report, HasFiguresOfTheShapesOfThePaper) {
  const std::vector<std::pair<std::string, std::string>> titles{
      {"parabola", "Parabola:"}, {"cone", "Cone:"}, {"power", "Power law:"}};
  for (const char* shape : {"parabola", "cone", "power", "rounded flat"}) {
    auto first = stored_result(), second = stored_result();
    second["scene"]["sweep"]["value"] = 90;
    for (auto* json : {&first, &second}) (*json)["scene"]["shape"] = shape;
    const auto page = page_of({first, second});
    for (const auto& [name, title] : titles) EXPECT_EQ(page.find(title) != std::string::npos, name == shape) << title;
    EXPECT_NE(page.find("family/phase-30"), std::string::npos) << shape;
  }
}

TEST(Report, RefusesAFolderWithoutResultsAndDamagedTables) {
  const ScratchFolder folder;
  const auto message = [&] { return refusal([&] { write_report(folder.path()); }); };
  EXPECT_NE(message().find("there is no result.json, trade.json"), std::string::npos) << message();
  folder.write("result.json", stored_result().dump());
  EXPECT_EQ(message(), "no error");
  folder.write("exact.json", "[{");
  EXPECT_NE(message().find("exact.json: "), std::string::npos) << message();
}

// Whatever a section finds where it does not expect it: no key is in the list of those that are looked at first.
TEST(Report, RefusesAResultThatASectionCannotReadByItsFile) {
  const ScratchFolder folder;
  auto damaged = stored_result();
  damaged["name"] = "family/phase-60";
  damaged["scene"]["normal_harmonics"] = "three of them";
  for (const char* name : {"good", "damaged"}) std::filesystem::create_directories(folder.path() / name);
  folder.write("good/result.json", stored_result().dump());
  folder.write("damaged/result.json", damaged.dump());
  expect_parts(refusal([&] { write_report(folder.path()); }),
               {(folder.path() / "damaged/result.json: ").string(), "is this a result of fretval?"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "index.html"));
}

// The answer of few cases as the terminal has it, then all tables.
TEST(Report, HasWordsForReadersWithoutScripts) {
  const ScratchFolder folder;
  folder.write("result.json", stored_result().dump());
  const auto page = text_of(write_report(folder.path()));
  const auto words = page.substr(page.find("<noscript>"), page.find("</noscript>") - page.find("<noscript>"));
  expect_parts(page, {"<title>family: 1 case over Motion / Phase · fretval</title>"});
  expect_parts(words, {"<pre>family: 1 case over Motion / Phase\n\nfamily/phase-30: ",
                       "                               finite elements              MDR\n",
                       "\n\ncase                      a ", "\nfamily/phase-30  "});
}

TEST(Report, MarksWhatDoesNotAgree) {
  auto single = stored_result();
  single["scene"].erase("sweep");
  expect_parts(page_of({single}),
               {"standard solid: the inner ", "Finite elements confirm the method of", "Computed on ", ". fretval 0.",
                ", deal.II 9.", ", MUMPS ", "To cite: The fretval authors, fretval 0."});
  single["verdict"] = "disagree";
  single["comparison"]["normal_force_max"]["verdict"] = "disagree";
  single["comparison"]["stick_radius_shakedown"]["difference"] = nullptr;
  expect_parts(page_of({single}),
               {"<td>+4.4e-05</td><td class=\"bad-cell\">disagree</td>", "<td class=\"bad-cell\">disagree</td></tr>",
                "Finite elements do not confirm the method of"});
}

// Every number another one: which of the two says it, in which unit, over which length.
TEST(Report, HasTheNumbersOfACaseInTheirPlaces) {
  auto json = stored_result();
  json["name"] = "a/case";
  json["scene"].erase("sweep");
  json["scene"]["contact_radius_unworn"] = 2;
  const std::map<std::string, std::pair<double, double>> numbers{{"contact_radius_max", {1.9, 1.8}},
                                                                 {"normal_force_max", {31, 32}},
                                                                 {"stick_radius_first_slip", {0.5, 0.6}},
                                                                 {"stick_radius_shakedown", {0.7, 0.9}}};
  for (const auto& [key, both] : numbers) {
    json["mdr"][key] = both.first;
    json["fe"][key] = both.second;
  }
  json["comparison"]["contact_radius_max"]["difference"] = -0.0625;
  json["comparison"]["normal_force_max"]["difference"] = 0.03125;
  json["cost"] = {{"seconds", {{"friction_history", 4.5}}},
                  {"dofs", 103},
                  {"time_steps", 12},
                  {"cycles", 3},
                  {"bodies", 7},
                  {"bodies_from_store", 2},
                  {"all",
                   {{"seconds", 12.25},
                    {"time_steps", 340},
                    {"cycles", 45},
                    {"computations", 6},
                    {"bodies", 9},
                    {"bodies_from_store", 4}}},
                  {"peak_memory_bytes", 64e6}};
  expect_parts(
      page_of({json}),
      {"<h2>Case a/case</h2>\n<p>parabola, standard solid", "<td>1.90000 m</td><td>-6.2e-02</td>",
       "<td>31.0000 N</td><td>+3.1e-02</td>", "<td>500.000 mm</td>", "<td>700.000 mm</td>",
       "<td>a/case</td><td>2.00000 m</td><td>500.000 mm</td><td>600.000 mm</td><td>700.000 mm</td>"
       "<td>900.000 mm</td><td>-6.2e-02</td>"
       "<td>+3.1e-02</td><td>agree</td>",
       "A case like a/case has 103 degrees of freedom and takes 12 time steps over 3 cycles in 4.50 s. Its proof "
       "took 6 computations, wear and refinements among them: 340 time steps, 45 cycles, 12.2 s of one "
       "processor. Peak memory 64 MB. A body is a mesh with its operators: 5 made, 4 from the store."});
}

// The amplitude at which slip begins with its bar, a_inf over a0.
// A phase sweep at another frequency ratio is no point of the paper's figure 3.
TEST(Report, KeepsOtherMotionsApart) {
  auto paper = stored_result(), ratio = stored_result(), harmonics = stored_result();
  ratio["name"] = "at a ratio";
  ratio["scene"]["tangential_frequency"] = 1.5;
  ratio["scene"]["contact_radius_unworn"] = 2;
  ratio["mdr"]["stick_radius_first_slip"] = 0.25;
  ratio["fe"]["stick_radius_shakedown"] = 1.5;
  harmonics["name"] = "with harmonics";
  harmonics["scene"]["tangential_frequency"] = 1;
  harmonics["scene"]["normal_harmonics"] = {{{"frequency", 1}}, {{"frequency", 3}}};
  expect_parts(page_of({paper, ratio, harmonics}), {"Other motions", "at a ratio", "1.5 Hz", "2.00000 m", "250.000 mm",
                                                    "1.50000 m", "with harmonics", "1 Hz, 3 Hz"});
  const auto only = page_of({ratio, harmonics});
  EXPECT_EQ(only.find("figure 3 of the paper"), std::string::npos);
  EXPECT_EQ(page_of({paper}).find("Other motions"), std::string::npos);
}

TEST(Report, HasTheRatiosOfAWornProfile) {
  auto json = stored_result("limiting");
  json["name"] = "worn";
  json["scene"]["contact_radius_unworn"] = 2;
  json["mdr"]["worn_radius"] = 2.5;
  json["fe"]["limiting_amplitude"] = 1.25;
  json["comparison"]["limiting_amplitude"] = {
      {"difference", 0.25}, {"tolerance", 1e-3}, {"error_bar", 0.5}, {"verdict", "inconclusive"}, {"pass", false}};
  json["fe"]["slip_inside_stick_zone"] = 0.25;
  json["fe"]["force_outside_stick_zone"] = 0.125;
  json["fe"]["touch_indentation"] = 1.5;
  json["comparison"]["normal_force_max"]["difference"] = -0.03125;
  expect_parts(page_of({json}),
               {"<td>worn</td><td>1.250000</td><td>5e-01</td><td>2.5e-01</td><td>1.2e-01</td><td>-3.1e-02</td>"
                "<td>1.500000 d max</td><td>2.00000 m</td><td>2.50000 m</td>"});
}

TEST(Report, DoesWithoutResultsWhereASuiteWasRun) {
  const ScratchFolder folder;
  folder.write("exact.json", nlohmann::ordered_json::array({stored_convergence_row()}).dump());
  const auto page = shown(text_of(write_report(folder.path())));
  expect_parts(page, {"1 of 1 rows pass"});
  EXPECT_EQ(page.find("All cases"), std::string::npos);
}

TEST(Report, RefusesADamagedFileOfASuiteByItsName) {
  for (const char* name : {"tolerance.json", "extremes.json", "random.json", "exact.json"}) {
    const ScratchFolder folder;
    folder.write(name, R"({"records": [1]})");
    try {
      write_report(folder.path());
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(folder.path() / "index.html")) << name;
  }
}

/// A folder with a case, a sweep over friction, a wearing indenter, and prescribed forces, each coarse.
void run_all_kinds(const ScratchFolder& folder) {
  folder.write("sweep.prm", fmt::format("include {}/cases/examples/fretting.prm\nsubsection Sweep\n"
                                        "  set Entry = Friction / Coefficient\n  set Values = 0.4, 0.5, 0.6\nend\n",
                                        FRETVAL_SOURCE_DIR));
  const auto run = fretval_run(fmt::format("run {0}examples/fretting.prm {1}/sweep.prm {0}wear/wear-to-the-limit.prm "
                                           "{0}forces/both-cone-elastic.prm --proof bars -o {1}/out",
                                           std::string(FRETVAL_SOURCE_DIR) + "/cases/", folder.path().string()),
                               folder);
  // Bars that nothing is refined for may be wider than the tolerance.
  ASSERT_TRUE(run.exit_code <= exit_disagree || run.exit_code == exit_not_resolved) << run.exit_code << run.err;
}

/// A report of every kind of section, in a folder, as a browser draws it.
class ReportSlow : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
    run_all_kinds(folder_);
    const auto out = folder_.path() / "out";
    fs::create_directories(out / "trade");
    folder_.write("out/trade/trade.json", stored_trade().dump());
    folder_.write("out/exact.json", nlohmann::ordered_json::array({stored_convergence_row()}).dump());
    folder_.write("out/random.json", suite_json(run_of({row_of(1e-3, 2e-3, "a"), row_of(3e-3, 8e-3, "b")})).dump());
    page_ = write_report(out);
  }

  /// The document after its scripts have run.
  [[nodiscard]] std::string drawn(const fs::path& page) const { return browsed(page, "--dump-dom", folder_); }

  /// Attributes that a page has after a script of ours has run in it.
  [[nodiscard]] std::string examined(const std::string& page, const std::string& script) const {
    return drawn(folder_.write("examined.html", page + "<script>" + script + "</script>"));
  }

  /// A number that a script finds of the document in a window of so many pixels; a frame, as no window of the browser
  /// is narrower than 500.
  [[nodiscard]] int found_in_frame(const std::string& page, int width, const std::string& number) const {
    folder_.write("framed.html", page);
    const auto outer = folder_.write(
        "frame.html", fmt::format("<html><body><iframe id=\"f\" src=\"framed.html\" width=\"{}\" height=\"3000\" "
                                  "style=\"border:0\" onload=\"const page = document.getElementById('f')"
                                  ".contentDocument; document.documentElement.dataset.found = {}\"></iframe>"
                                  "</body></html>",
                                  width, number));
    const auto text = browsed(outer, "--hide-scrollbars --allow-file-access-from-files --dump-dom", folder_);
    const std::string before = "data-found=\"";
    const auto at = text.find(before);
    EXPECT_NE(at, std::string::npos);
    return at == std::string::npos ? 0 : std::stoi(text.substr(at + before.size()));
  }

  /// Pixels that a page of so many takes across.
  [[nodiscard]] int width_in_frame(const std::string& page, int width) const {
    return found_in_frame(page, width, "page.documentElement.scrollWidth");
  }

  /// How many tables scroll sideways, folded ones among them.
  [[nodiscard]] int scrolling_tables(const std::string& page, int width) const {
    return found_in_frame(page, width,
                          "(page.querySelectorAll('details').forEach((one) => one.open = true), "
                          "[...page.querySelectorAll('.scroll')].filter((box) => box.scrollWidth > box.clientWidth)"
                          ".length)");
  }

  /// Words on paper, each with the box that it takes on a page of some width, as XHTML.
  [[nodiscard]] std::string printed(const fs::path& page) const {
    const auto file = folder_.path() / "printed.pdf";
    browsed(page, "--no-pdf-header-footer --print-to-pdf=" + quoted(file), folder_);
    return shell_run("pdftotext -bbox " + quoted(file) + " -", folder_).out;
  }

  /// What tests/comparison/report/contrast.js says of the page with one text in the place of another.
  [[nodiscard]] nlohmann::json contrast_with(const std::string& part, const std::string& other) const {
    const auto examiner = text_of(fs::path(FRETVAL_SOURCE_DIR) / "tests/comparison/report/contrast.js");
    const auto page =
        folder_.write("examined.html", replace(text_of(page_), part, other) + "<script>" + examiner + "</script>");
    return found_in(drawn(page), "contrast");
  }

  /// What tests/comparison/report/touch.js says of a page, or of its first plots.
  [[nodiscard]] nlohmann::json touched(const fs::path& page, const std::string& n_plots = "") const {
    const auto examiner = fs::path(FRETVAL_SOURCE_DIR) / "tests/comparison/report/touch.js";
    const auto run = shell_run(
        "node " + quoted(examiner) + " " + quoted(page) + " " + quoted(folder_.path() / "profile") + " " + n_plots,
        folder_);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return nlohmann::json::parse(run.out);
  }

  ScratchFolder folder_;
  fs::path page_;
};

// What a person sees: every plot is drawn.
TEST_F(ReportSlow, IsDrawnByABrowser) {
  const auto text = drawn(page_);
  const int n_plots = n_of("<div class=\"plot\" data-plot=\"", text);
  EXPECT_GE(n_plots, 25);
  EXPECT_NE(text.find(fmt::format("data-plots-drawn=\"{}\"", n_plots)), std::string::npos);
  EXPECT_EQ(n_of(">no data<", text), 0);
  expect_parts(text, {"Friction / Coefficient", "Wear to the end", "Prescribed forces", "Suite extremes",
                      "Speed and accuracy", "Pressure and traction"});
}

// On a telephone the page does not scroll sideways; tables do, in boxes of their own.
TEST_F(ReportSlow, IsAsWideAsATelephone) {
  const auto page = text_of(page_);
  EXPECT_EQ(width_in_frame(page, 390), 390);
  // What the measure is there for.
  EXPECT_EQ(width_in_frame(replace(page, "<header>", "<div style=\"width:600px\">wide</div><header>"), 390), 616);
}

// 15 pixels of the window are its scroll bar.
TEST_F(ReportSlow, ScrollsNoTableOnAScreen) {
  const auto page = text_of(page_);
  EXPECT_EQ(scrolling_tables(page, 1265), 0);
  EXPECT_EQ(width_in_frame(page, 1265), 1265);
  EXPECT_GE(scrolling_tables(page, 390), 3) << "what the measure is there for";
}

// The table of all cases is folded on the screen. Every word lies within the paper and its margin of 14 mm, which are
// 52 whole pixels or 39 points.
TEST_F(ReportSlow, IsPrintedWithWhatIsFoldedAndNothingCutOff) {
  if (std::system("command -v pdftotext >/dev/null") != 0) GTEST_SKIP() << "poppler-utils is not installed";
  const auto text = printed(page_);
  const auto unfolded = text.find(">Stick</word>");  // the summary of the table
  EXPECT_NE(unfolded, std::string::npos);
  EXPECT_NE(text.find(">sweep/coefficient-0.6</word>", unfolded), std::string::npos);
  const auto number_after = [&](std::size_t from, const char* key) {
    const auto at = text.find(key, from) + std::string(key).size();
    return std::stod(text.substr(at));
  };
  constexpr double margin = 39, roundoff = 0.1;
  double width = 0;
  int n_words = 0;
  for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 5, "<page") == 0) width = number_after(at, "width=\"");
    if (text.compare(at, 5, "<word") != 0) continue;
    ++n_words;
    EXPECT_GE(number_after(at, "xMin=\""), margin - roundoff) << text.substr(at, 120);
    EXPECT_LE(number_after(at, "xMax=\""), width - margin + roundoff) << text.substr(at, 120);
  }
  EXPECT_GT(n_words, 1000);
}

// Every drawing is reached by the tabulator, and the arrow keys walk through its pieces.
TEST_F(ReportSlow, OfManyCasesIsPrintedWithoutTheTableOfAllOfThem) {
  if (std::system("command -v pdftotext >/dev/null") != 0) GTEST_SKIP() << "poppler-utils is not installed";
  const auto n_named = [&](int n_cases) {
    const ScratchFolder folder;
    for (int i = 0; i < n_cases; ++i) {
      auto json = stored_result();
      json["name"] = "many/phase-" + std::to_string(i);
      json["scene"]["sweep"] = {{"family", "many"}, {"entry", "Motion / Phase"}, {"value", i}};
      fs::create_directories(folder.path() / std::to_string(i));
      folder.write(std::to_string(i) + "/result.json", json.dump());
    }
    return n_of(">many/phase-", printed(write_report(folder.path())));
  };
  EXPECT_GE(n_named(60), 60) << "of few it is printed";
  EXPECT_LT(n_named(61), 20);
}

TEST_F(ReportSlow, IsUsedWithoutAMouse) {
  const auto text = examined(text_of(page_), R"(
    let silent = [], n = 0;
    for (const svg of document.querySelectorAll("[data-plot] svg.canvas")) {
      const tip = svg.closest("[data-plot]").querySelector(".tip"), press = (key) => svg.dispatchEvent(new KeyboardEvent("keydown", {key}));
      const name = svg.getAttribute("aria-label");
      ++n;
      if (svg.tabIndex !== 0) silent.push("not reached: " + name);
      press("ArrowRight");
      const first = tip.textContent;
      if (tip.hidden || !first) silent.push("says nothing: " + name);
      press("ArrowRight"); press("ArrowUp"); press("ArrowRight");
      if (tip.hidden) silent.push("falls silent: " + name);
      press("Escape");
      if (!tip.hidden) silent.push("goes on: " + name);
    }
    document.documentElement.dataset.silent = JSON.stringify(silent);
    document.documentElement.dataset.reached = n;)");
  expect_parts(text, {"data-silent=\"[]\""});
  const auto at = text.find("data-reached=\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_GE(std::stoi(text.substr(at + 14)), 25);
}

// On a telephone: a tap says what the pointer says, two fingers magnify, the slider follows, and the page scrolls.
TEST_F(ReportSlow, IsUsedByFingers) {
  const auto found = touched(page_);
  EXPECT_EQ(found.at("problems"), nlohmann::json::array());
  EXPECT_GE(found.at("magnified"), 20);
  EXPECT_GE(found.at("slid"), 3);
  // What the examiner is there for.
  const auto without = [&](const std::string& part, const std::string& other) {
    return touched(folder_.write("examined.html", replace(text_of(page_), part, other)), "1").at("problems").dump();
  };
  expect_parts(without("mousemove touchstart", "touchnothing"), {"the pointer finds nothing"});
  expect_parts(without("svg.on(\"touchstart.pinch touchmove.pinch\"", "svg.on(\"click.pinch\""),
               {"two fingers do not magnify it"});
  expect_parts(without("0).style(\"touch-action\", \"pan-y\")", "0).style(\"touch-action\", \"none\")"),
               {"the page does not scroll under a finger"});
}

TEST_F(ReportSlow, HasTheContrastThatTheGuidelinesAskFor) {
  const auto found = contrast_with("</body>", "</body>");
  EXPECT_EQ(found.at("failures"), nlohmann::json::array());
  EXPECT_GT(found.at("texts"), 500);
  EXPECT_GT(found.at("marks"), 500);
  // The dark page on any screen.
  EXPECT_EQ(contrast_with("(prefers-color-scheme: dark)", "(min-width: 1px)").at("failures"), nlohmann::json::array());
  // What the examiner is there for.
  expect_parts(contrast_with("--soft: #566070", "--soft: #8a94a4").at("failures").dump(),
               {"texts FIGCAPTION. rgb(138, 148, 164) on 255,255,255: 3.0"});
  expect_parts(contrast_with("--axis: #858d97", "--axis: #b0b7c0").at("failures").dump(), {"marks path.domain"});
}

}  // namespace
}  // namespace fretval
