#include "comparison/report/drawing/plots.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "comparison/report/drawing/palette.h"
#include "comparison/report/drawing/share_bars.h"
#include "comparison/report/drawing/zone_map.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// A string of a gnuplot script. In double quotes gnuplot would run what stands between backquotes as a shell command.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c == '`' ? '\'' : c;
  }
  return result + '"';
}

struct StyleNames {
  const char *json, *gnuplot;
};
/// In the order of the enumeration.
constexpr std::array styles{StyleNames{"line", "with lines lw 1.6"},
                            StyleNames{"dashed", "with lines lw 1.6 dt 2"},
                            StyleNames{"line points", "with linespoints lw 1.6 pt 7 ps 0.45"},
                            StyleNames{"points", "with points pt 7 ps 0.45"},
                            StyleNames{"open points", "with points pt 6 ps 0.55"},
                            StyleNames{"triangles", "with points pt 9 ps 0.9"}};

const char* colour_of(const Filling& series) {
  return palette_colour(series.at("colour").get<std::size_t>());
}

std::string style_of(const Filling& series) {
  const auto* style = std::find_if(styles.begin(), styles.end(),
                                   [&](const StyleNames& names) { return series.at("style") == names.json; });
  return fmt::format("{} lc rgb '{}'", style->gnuplot, colour_of(series));
}

bool is_drawn(const Filling& plot, double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && (!plot.at("log_y") || y > 0) && (!plot.at("log_x") || x > 0);
}

/// At the places of a series what an axis can show; NaN where it cannot.
std::vector<double> shown(const Filling& plot, const Filling& series) {
  const auto x = series.at("x").get<std::vector<double>>();
  auto y = series.at("y").get<std::vector<double>>();
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!is_drawn(plot, x[i], y[i])) y[i] = std::nan("");
  return y;
}

bool has_points(const Filling& plot) {
  for (const auto& series : plot.at("series"))
    for (const double y : shown(plot, series))
      if (std::isfinite(y)) return true;
  return false;
}

std::string text_in(const Filling& plot, const char* key) {
  return quoted(plot.at(key).get<std::string>());
}

std::string number_or_nan(double value) {
  return std::isfinite(value) ? fmt::format("{:.10g}", value) : "nan";
}

/// nan: no bar there.
std::string bar_at(const Filling& series, std::size_t i) {
  if (!series.contains("bar") || !series["bar"].at(i).is_number()) return "nan";
  const double bar = series["bar"][i].get<double>();
  return bar > 0 ? number_or_nan(bar) : "nan";
}

/// Vertical lines with their names above, where the axis has them.
std::string marks_of(const Filling& plot) {
  if (!plot.contains("marks")) return "";
  std::string script = "set title offset 0,0.9\n";
  for (const auto& mark : plot["marks"]) {
    const double x = mark.at("x").get<double>();
    if (const auto range = plot.find("x_range"); range != plot.end())
      if (x < range->at(0).get<double>() || x > range->at(1).get<double>()) continue;
    script += fmt::format(
        "set arrow from first {0:.10g}, graph 0 to first {0:.10g}, graph 1 nohead lw 1 dt 3 lc rgb '#666666'\n"
        "set label {1} at first {0:.10g}, graph 1.04 center tc rgb '#444444'\n",
        x, text_in(mark, "name"));
  }
  return script;
}

/// The error bars of a series, whose half lengths stand in the third column; below its points.
std::string bars_of(const std::string& name, const Filling& series) {
  if (!series.contains("bar")) return "";
  return fmt::format("{} using 1:($2-$3):(0):(2*$3) with vectors nohead lw 1.2 lc rgb '{}' notitle, ", name,
                     colour_of(series));
}

constexpr int pixels_of_a_name = 20;  // in the key

/// Of the key: long names stand in one column, short ones in two.
int key_rows_of(const Filling& plot) {
  constexpr std::size_t longest_of_two = 24;
  int n = 0;
  bool is_long = false;
  for (const auto& series : plot.at("series")) {
    const auto label = series.at("label").get<std::string>();
    n += label.empty() ? 0 : 1;
    is_long = is_long || label.size() > longest_of_two;
  }
  return std::max(1, is_long ? n : (n + 1) / 2);
}

std::string script_of(const Filling& plot) {
  std::ostringstream script;
  const int key_rows = key_rows_of(plot);
  script
      << fmt::format("reset\nset terminal svg size 640,{} dynamic font 'Helvetica,15' background '#ffffff'\n",
                     390 + pixels_of_a_name * key_rows)
      << "set encoding utf8\nset border 3 lc rgb '#666666'\nset tics nomirror\nset grid lc rgb '#dddddd' lt 1 lw 0.5\n"
      << "set title " << text_in(plot, "title") << "\nset xlabel " << text_in(plot, "x_label") << "\nset ylabel "
      << text_in(plot, "y_label") << "\nset datafile missing 'nan'\n"
      << fmt::format("set key bmargin center vertical maxrows {} Left reverse\nset bmargin {}\n", key_rows,
                     4 + key_rows);
  const bool has_tics = plot.contains("x_tics");
  if (plot.at("log_y")) script << "set logscale y\nset format y '10^{%L}'\n";
  if (plot.at("log_x")) script << "set logscale x\n" << (has_tics ? "" : "set format x '10^{%L}'\n");
  if (has_tics) script << fmt::format("set xtics ({:g})\n", fmt::join(plot["x_tics"].get<std::vector<double>>(), ", "));
  for (const char* axis : {"x", "y"})
    if (const auto range = plot.find(axis + std::string("_range")); range != plot.end())
      script << fmt::format("set {}range [{}:{}]\n", axis, range->at(0).get<double>(), range->at(1).get<double>());
  if (plot.contains("equal_scales")) script << "set size ratio -1\n";
  script << marks_of(plot);
  std::string drawn;
  for (const auto& series : plot.at("series")) {
    const auto name = fmt::format("$data{}", &series - &plot["series"].front());
    script << name << " << EOD\n";
    const auto x = series.at("x").get<std::vector<double>>(), y = shown(plot, series);
    for (std::size_t i = 0; i < x.size(); ++i)
      script << fmt::format("{:.10g} {} {}\n", x[i], number_or_nan(y[i]), bar_at(series, i));
    script << "EOD\n";
    drawn += fmt::format("{}{}{} using 1:2 {} {}", drawn.empty() ? "plot " : ", ", bars_of(name, series), name,
                         style_of(series), series.at("label") == "" ? "notitle" : "title " + text_in(series, "label"));
  }
  script << drawn << "\n";
  return script.str();
}

/// A file in the temporary folder that is gone with the object.
class ScratchFile {
 public:
  ScratchFile() {
    std::string pattern = (fs::temp_directory_path() / "fretval-plot-XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    if (descriptor < 0)
      throw std::system_error(errno, std::generic_category(), "cannot make a temporary file for a plot");
    close(descriptor);
    path_ = pattern;
  }
  ~ScratchFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What gnuplot says to a script, errors included.
std::string output_of_gnuplot(const std::string& script) {
  const ScratchFile file;
  errno = 0;
  std::ofstream stream(file.path());
  stream << script;
  stream.close();
  if (!stream)
    throw std::system_error(errno ? errno : EIO, std::generic_category(), "cannot write " + file.path().string());
  FILE* pipe = popen(("gnuplot '" + file.path().string() + "' 2>&1").c_str(), "r");
  if (!pipe) throw std::system_error(errno, std::generic_category(), "gnuplot could not be started");
  std::string output;
  std::array<char, 65536> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) output.append(buffer.data(), n);
  if (pclose(pipe) != 0)
    throw std::system_error(std::make_error_code(std::errc::io_error),
                            "gnuplot could not draw: " + output.substr(0, 400));
  return output;
}

/// In place of a plot, for which gnuplot would fail.
std::string nothing_to_draw(const Filling& plot) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 440\"><text x=\"320\" y=\"220\" "
      "text-anchor=\"middle\">{}: no data</text></svg>",
      html_escaped(plot.at("title").get<std::string>()));
}

std::vector<double> rounded(std::vector<double> values) {
  for (double& value : values)
    if (std::isfinite(value)) value = std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
  return values;
}

bool is_for_gnuplot(const Filling& plot) {
  return !plot.contains("kind") && has_points(plot);
}

/// The first element of a drawing, which is taken off it.
std::string next_element(std::string& drawn, const Filling& plot) {
  const std::string closing = "</svg>";
  const auto begin = drawn.find("<svg"), end = drawn.find(closing, begin);
  if (begin == std::string::npos || end == std::string::npos)
    throw std::system_error(
        std::make_error_code(std::errc::io_error),
        "gnuplot could not draw '" + plot.at("title").get<std::string>() + "': " + drawn.substr(0, 400));
  auto element = drawn.substr(begin, end + closing.size() - begin);
  drawn.erase(0, end + closing.size());
  return element;
}

}  // namespace

Filling json_of(const Plot& plot) {
  Filling json{{"title", plot.title},
               {"x_label", plot.x_label},
               {"y_label", plot.y_label},
               {"log_x", plot.log_x},
               {"log_y", plot.log_y}};
  if (plot.x_range) json["x_range"] = {plot.x_range->first, plot.x_range->second};
  if (plot.y_range) json["y_range"] = {plot.y_range->first, plot.y_range->second};
  if (plot.equal_scales) json["equal_scales"] = true;
  if (!plot.x_tics.empty()) json["x_tics"] = plot.x_tics;
  for (const auto& [name, x] : plot.marks) json["marks"].push_back({{"name", name}, {"x", x}});
  json["series"] = Filling::array();
  for (const auto& series : plot.series) {
    Filling one{{"label", series.label},
                {"style", styles[static_cast<std::size_t>(series.style)].json},
                {"colour", series.colour},
                {"x", rounded(series.x)},
                {"y", rounded(series.y)}};
    if (!series.bar.empty()) one["bar"] = rounded(series.bar);
    json["series"].push_back(std::move(one));
  }
  return json;
}

std::vector<std::string> svgs(const std::vector<const Filling*>& plots) {
  std::string script;
  for (const auto* plot : plots)
    if (is_for_gnuplot(*plot)) script += script_of(*plot);
  std::string drawn = script.empty() ? "" : output_of_gnuplot(script);
  std::vector<std::string> elements;
  for (const auto* plot : plots)
    if (plot->contains("kind"))
      elements.push_back(plot->at("kind") == "map" ? zone_map_svg(*plot) : share_bars_svg(*plot));
    else
      elements.push_back(has_points(*plot) ? next_element(drawn, *plot) : nothing_to_draw(*plot));
  return elements;
}

}  // namespace fretval
