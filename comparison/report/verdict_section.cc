#include "comparison/report/verdict_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparison/accuracy/proof.h"
#include "comparison/accuracy/quantity.h"
#include "comparison/support/escape.h"

namespace fretval {
namespace {

using Results = std::vector<StoredResult>;
using nlohmann::ordered_json;

std::string title_with_scale(Quantity quantity) {
  return fmt::format("{} ({})", traits_of(quantity).title, traits_of(quantity).scale);
}

/// How far the finite elements are proved, see Proof.
std::string proof_text(const Results& results) {
  std::map<std::string, int> counts;
  for (const auto& r : results) ++counts[r.json.value("proof", "")];
  std::string html;
  const auto add = [&](Proof proof, const char* text) {
    const auto found = counts.find(name_of(proof));
    if (found == counts.end()) return;
    if (counts.size() > 1) html += fmt::format("{} cases: ", found->second);
    html += text;
  };
  add(Proof::none,
      "The answer of the finite elements alone, computed without error bars (<code>--proof none</code>): what it is "
      "worth only the difference tells. ");
  add(Proof::bars,
      "The finite elements have error bars, each source measured by its own refinement, and are taken as they are "
      "(<code>--proof bars</code>). ");
  add(Proof::tolerance,
      "The finite elements have error bars, each source measured by its own refinement, and were refined while the "
      "bars "
      "were wider than the tolerance (<code>--proof tolerance</code>). ");
  return html + "A comparison whose bar is wider than its tolerance is inconclusive.";
}

}  // namespace

Extreme extreme_of(const Results& results, const char* key) {
  Extreme extreme;
  for (const auto& r : results) {
    const auto& comparison = r.json.at("comparison");
    if (!comparison.contains(key)) continue;
    const auto& d = comparison[key];
    ++extreme.n_compared;
    extreme.n_pass += d.value("pass", false) ? 1 : 0;
    extreme.n_inconclusive += d.value("verdict", "") == "inconclusive" ? 1 : 0;
    const double tolerance = d.value("tolerance", 0.0);
    const bool has_bar = d.contains("error_bar") && d["error_bar"].is_number();
    if (has_bar) {
      const double bar = d["error_bar"].get<double>();
      ++extreme.n_with_bar;
      if (!d["difference"].is_number() || std::abs(d["difference"].get<double>()) <= bar) ++extreme.n_covered;
      extreme.largest_bar = std::max(extreme.largest_bar, bar);
    }
    if (!d["difference"].is_number()) continue;
    if (std::abs(d["difference"].get<double>()) < std::abs(extreme.difference)) continue;
    extreme.difference = d["difference"].get<double>();
    extreme.tolerance = tolerance;
    extreme.name = r.json.at("name").get<std::string>();
  }
  return extreme;
}

std::string verdict_section(const Results& results) {
  const auto n_pass = std::count_if(results.begin(), results.end(),
                                    [](const auto& r) { return r.json.at("pass").template get<bool>(); });
  const bool all = static_cast<std::size_t>(n_pass) == results.size();
  std::string html = fmt::format(
      "<p class=\"lead\"><span class=\"badge {}\">{}</span> Finite elements and MDR agree within tolerance in {} of {} "
      "cases.</p>\n<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>cases</th><th>agree</th>"
      "<th>inconclusive</th><th>largest difference</th><th>largest error bar</th><th>tolerance</th>"
      "<th>difference within the bar</th><th>largest difference in</th></tr></thead><tbody>\n",
      all ? "good" : "bad", all ? "confirmed" : "not confirmed", n_pass, results.size());
  for (const auto quantity : quantities_by_interest) {
    const auto e = extreme_of(results, name_of(quantity));
    if (e.n_compared == 0) continue;
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td><td>{:.1e}</td><td>{}</td><td>{:.0e}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        title_with_scale(quantity), e.n_compared, e.n_pass == e.n_compared ? "" : " class=\"bad-cell\"", e.n_pass,
        e.n_inconclusive, e.difference, e.n_with_bar > 0 ? fmt::format("{:.1e}", e.largest_bar) : "–", e.tolerance,
        e.n_with_bar > 0 ? fmt::format("{} of {}", e.n_covered, e.n_with_bar) : "–", html_escaped(e.name));
  }
  return html + "</tbody></table></div>\n<p class=\"soft\">" + proof_text(results) + "</p>\n";
}

/// Which sources make up the error bars: median and largest share of each over all results.
std::string budget_section(const Results& results) {
  std::map<std::string, std::map<std::string, std::vector<double>>> shares;  // by source and quantity
  for (const auto& r : results) {
    const auto& fe = r.json.at("fe");
    if (!fe.contains("error_estimate")) continue;
    for (const auto& [quantity, bar] : fe["error_estimate"].items())
      if (bar.is_object() && bar.contains("shares"))
        for (const auto& [source, share] : bar["shares"].items())
          if (share.value("estimate", ordered_json()).is_number())
            shares[source][quantity].push_back(share["estimate"].get<double>());
  }
  if (shares.empty()) return "";
  std::string html =
      "<h2>Error budget of the finite elements</h2>\n<div class=\"scroll\"><table><thead><tr><th>source: median, "
      "largest</th>";
  for (const auto quantity : quantities_by_interest) html += fmt::format("<th>{}</th>", title_with_scale(quantity));
  html += "</tr></thead><tbody>\n";
  for (auto& [source, by_quantity] : shares) {
    html += fmt::format("<tr><td>{}</td>", html_escaped(source));
    for (const auto quantity : quantities_by_interest) {
      auto& values = by_quantity[name_of(quantity)];
      std::sort(values.begin(), values.end());
      html += values.empty() ? "<td>–</td>"
                             : fmt::format("<td>{:.0e}, {:.0e}</td>", values[values.size() / 2], values.back());
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace fretval
