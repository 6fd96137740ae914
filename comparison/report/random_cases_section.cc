#include "comparison/report/random_cases_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

std::string cell(const ordered_json& value, const char* format = "{:.1e}") {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "–";
}

std::string quantity_row(const std::string& quantity, const ordered_json& d) {
  const auto n_above = d.at("above_bar").get<std::size_t>();
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.1f} %</td>"
      "<td>{:.1f} %</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      html_escaped(quantity), d.at("comparisons").get<std::size_t>(), n_above == 0 ? "" : " class=\"bad-cell\"",
      n_above, cell(d.at("median_error")), cell(d.at("high_error")), cell(d.at("median_bar")), cell(d.at("high_bar")),
      100 * d.at("share_above_1e-2").get<double>(), 100 * d.at("share_above_1e-1").get<double>(),
      d.at("unbounded").get<std::size_t>(), cell(d.at("low_effectivity"), "{:.1f}"),
      cell(d.at("median_effectivity"), "{:.1f}"));
}

std::string worst_row(const ordered_json& w) {
  const auto& failure = w.at("failure");
  std::string numbers = "<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td><td>–</td>";
  if (w.at("quantity").is_string())
    numbers =
        fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                    html_escaped(w.at("quantity").get<std::string>()), cell(w.at("mdr"), "{:.6f}"),
                    cell(w.at("fe"), "{:.6f}"), cell(w.at("error")), cell(w.at("bar")), cell(w.at("share"), "{:.2f}"));
  return fmt::format(
      "<tr><td>{}</td>{}<td class=\"words\">{}{}</td><td class=\"words\"><details><summary>case file</summary><pre>{}"
      "</pre></details></td></tr>\n",
      w.at("number").get<std::size_t>(), numbers, html_escaped(w.at("scene").get<std::string>()),
      failure.is_string() ? ": " + html_escaped(failure.get<std::string>()) : "",
      html_escaped(w.at("case_file").get<std::string>()));
}

std::string memory_text(const ordered_json& memory) {
  if (!memory.at("flat").is_boolean()) return "The memory was not judged.";
  return fmt::format("Resident memory: {:.1f} MB in the second quarter, {:.1f} MB in the last, {}.",
                     memory.at("start").get<double>() / 1e6, memory.at("end").get<double>() / 1e6,
                     memory.at("flat").get<bool>() ? "flat" : "it grows");
}

}  // namespace

std::string soak_section(const ordered_json& json) {
  const auto& s = json.at("summary");
  std::string quantities, worst;
  for (const auto& [quantity, d] : json.at("quantities").items())
    if (d.at("comparisons").get<std::size_t>() > 0) quantities += quantity_row(quantity, d);
  for (const auto& w : json.at("worst")) worst += worst_row(w);
  return fmt::format(
      "<h2>Random cases</h2>\n<p><span class=\"badge {}\">{}</span> {} (seed {}), on one coarse mesh without any "
      "refinement, {} friction histories in {:.0f} s. {} To repeat: <code>fretval check --suite soak</code>.</p>\n"
      "<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>comparisons</th><th>above bar</th>"
      "<th>error, median</th><th>90 % below</th><th>bar, median</th><th>90 % below</th><th>bars above 0.01</th>"
      "<th>above 0.1</th><th>unbounded</th><th>bar over error, 10 % below</th><th>median</th></tr></thead><tbody>\n"
      "{}</tbody></table></div>\n<p>The worst ten: error over bar.</p>\n<div class=\"scroll\"><table><thead><tr>"
      "<th>number</th><th>quantity</th><th>MDR</th><th>FE</th><th>error</th><th>bar</th><th>share</th><th>scene</th>"
      "<th></th></tr></thead><tbody>\n{}</tbody></table></div>\n",
      s.at("pass").get<bool>() ? "good" : "bad", s.at("pass").get<bool>() ? "pass" : "fail",
      html_escaped(s.at("verdict").get<std::string>()), s.at("seed").get<std::uint64_t>(),
      s.at("histories").get<long>(), s.at("seconds").get<double>(), memory_text(json.at("memory")), quantities, worst);
}

}  // namespace fretval
