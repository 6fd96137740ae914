#include "comparison/report/plots.h"

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

#include "comparison/support/escape.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

// Okabe and Ito's palette, distinguishable with colour-blind eyes.
constexpr std::array<const char*, 9> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                             "#56b4e9", "#6a51a3", "#555555", "#a6761d"};

/// A string of a gnuplot script. In double quotes gnuplot would run what stands between backquotes as a shell command.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c == '`' ? '\'' : c;
  }
  return result + '"';
}

std::string style_of(const Series& series) {
  const char* colour = palette[static_cast<std::size_t>(series.colour) % palette.size()];
  switch (series.style) {
    case Series::Style::line:
      return fmt::format("with lines lw 1.6 lc rgb '{}'", colour);
    case Series::Style::dashed:
      return fmt::format("with lines lw 1.6 dt 2 lc rgb '{}'", colour);
    case Series::Style::line_points:
      return fmt::format("with linespoints lw 1.6 pt 7 ps 0.45 lc rgb '{}'", colour);
    case Series::Style::points:
      return fmt::format("with points pt 7 ps 0.45 lc rgb '{}'", colour);
    case Series::Style::triangles:
      return fmt::format("with points pt 9 ps 0.9 lc rgb '{}'", colour);
    default:
      return fmt::format("with points pt 6 ps 0.55 lc rgb '{}'", colour);
  }
}

bool is_drawn(const Plot& plot, const Series& series, std::size_t i) {
  return std::isfinite(series.x[i]) && std::isfinite(series.y[i]) && (!plot.log_y || series.y[i] > 0) &&
         (!plot.log_x || series.x[i] > 0);
}

std::string script_of(const Plot& plot) {
  std::ostringstream script;
  script
      << "reset\nset terminal svg size 640,440 dynamic font 'Helvetica,15' background '#ffffff'\n"
      << "set encoding utf8\nset border 3 lc rgb '#666666'\nset tics nomirror\nset grid lc rgb '#dddddd' lt 1 lw 0.5\n"
      << "set title " << quoted(plot.title) << "\nset xlabel " << quoted(plot.x_label) << "\nset ylabel "
      << quoted(plot.y_label) << "\nset datafile missing 'nan'\n"
      << (plot.key_right ? "set key outside right top\n"
                         : "set key bmargin center vertical maxrows 3\nset bmargin 7\n");
  if (plot.log_y) script << "set logscale y\nset format y '10^{%L}'\n";
  if (plot.log_x) script << "set logscale x\n" << (plot.x_tics.empty() ? "set format x '10^{%L}'\n" : "");
  if (!plot.x_tics.empty()) script << fmt::format("set xtics ({:g})\n", fmt::join(plot.x_tics, ", "));
  if (plot.x_range) script << fmt::format("set xrange [{}:{}]\n", plot.x_range->first, plot.x_range->second);
  if (plot.y_range) script << fmt::format("set yrange [{}:{}]\n", plot.y_range->first, plot.y_range->second);
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    script << "$data" << k << " << EOD\n";
    const auto& series = plot.series[k];
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const bool drawn = is_drawn(plot, series, i);
      script << fmt::format("{:.10g} {}\n", series.x[i], drawn ? fmt::format("{:.10g}", series.y[i]) : "nan");
    }
    script << "EOD\n";
  }
  script << "plot ";
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const auto& series = plot.series[k];
    script << (k ? ", " : "") << "$data" << k << " using 1:2 " << style_of(series)
           << (series.label.empty() ? " notitle" : " title " + quoted(series.label));
  }
  script << "\n";
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

bool has_points(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [&](const Series& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (is_drawn(plot, series, i)) return true;
    return false;
  });
}

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
std::string nothing_to_draw(const Plot& plot) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 440\"><text x=\"320\" y=\"220\" "
      "text-anchor=\"middle\">{}: no data</text></svg>",
      html_escaped(plot.title));
}

}  // namespace

std::vector<std::string> svgs(const std::vector<Plot>& plots) {
  std::string script;
  for (const auto& plot : plots)
    if (has_points(plot)) script += script_of(plot);
  std::string drawn = script.empty() ? "" : output_of_gnuplot(script);
  std::vector<std::string> elements;
  std::size_t end = 0;
  for (const auto& plot : plots) {
    if (!has_points(plot)) {
      elements.push_back(nothing_to_draw(plot));
      continue;
    }
    const std::string closing = "</svg>";
    const auto begin = drawn.find("<svg", end);
    end = drawn.find(closing, begin);
    if (begin == std::string::npos || end == std::string::npos)
      throw std::system_error(std::make_error_code(std::errc::io_error),
                              "gnuplot could not draw '" + plot.title + "': " + drawn.substr(0, 400));
    end += closing.size();
    elements.push_back(drawn.substr(begin, end - begin));
  }
  return elements;
}

}  // namespace fretval
