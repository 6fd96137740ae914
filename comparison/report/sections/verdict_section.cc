#include "comparison/report/sections/verdict_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "comparison/accuracy/proof.h"
#include "comparison/quantities/quantity.h"
#include "comparison/report/sections/values_table.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

using Results = std::vector<StoredResult>;
using nlohmann::ordered_json;

std::string title_with_scale(Quantity quantity) {
  return fmt::format("{} ({})", traits_of(quantity).title, traits_of(quantity).scale);
}

/// How far the finite elements are proved, see Proof.
std::string proof_text(const Results& results) {
  std::map<std::string, std::size_t> counts;
  for (const auto& r : results) ++counts[r.json.value("proof", "")];
  std::string text;
  const auto add = [&](Proof proof, const char* meaning) {
    const auto found = counts.find(name_of(proof));
    if (found == counts.end()) return;
    if (counts.size() > 1) text += counted(found->second, "case") + ": ";
    text += meaning;
  };
  add(Proof::none,
      "The answer of the finite elements alone, computed without error bars (--proof none): what it is "
      "worth only the difference tells. ");
  add(Proof::bars,
      "The finite elements have error bars, each source measured by its own refinement, and are taken as they are "
      "(--proof bars). ");
  add(Proof::tolerance,
      "The finite elements have error bars, each source measured by its own refinement, and were refined while the "
      "bars "
      "were wider than the tolerance (--proof tolerance). ");
  return text + "A comparison whose bar is wider than its tolerance is inconclusive.";
}

/// "Finite elements confirm MDR to 1.1e-05; shakedown radius 792.76 ± 0.07 µm."
std::string sentence_of(const StoredResult& result) {
  const auto answer = answer_of(result.json);
  auto sentence = answer.verdict;
  sentence.front() = static_cast<char>(std::toupper(sentence.front()));
  for (const auto& row : answer.rows)
    if (row.title == traits_of(Quantity::stick_radius_shakedown).title) sentence += "; shakedown radius " + row.fe;
  return sentence + ".";
}

std::string were(std::size_t n) {
  return counted(n, "case") + (n == 1 ? " is" : " are");
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

Filling verdict_section(const Results& results) {
  const auto n_pass = std::count_if(results.begin(), results.end(),
                                    [](const auto& r) { return r.json.at("pass").template get<bool>(); });
  const bool all = static_cast<std::size_t>(n_pass) == results.size();
  const auto n_beyond = static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const auto& r) { return r.is_beyond_mdr(); }));
  const auto n_compared = results.size() - n_beyond;
  Table table{{"quantity", "cases", "agree", "inconclusive", "largest difference", "largest error bar", "tolerance",
               "difference within the bar", "largest difference in"}};
  for (const auto quantity : quantities_by_interest) {
    const auto e = extreme_of(results, name_of(quantity));
    if (e.n_compared == 0) continue;
    table.rows.push_back({title_with_scale(quantity), fmt::format("{}", e.n_compared),
                          bad_if(e.n_pass != e.n_compared, fmt::format("{}", e.n_pass)),
                          fmt::format("{}", e.n_inconclusive), number_text(e.difference),
                          e.n_with_bar > 0 ? number_text(e.largest_bar) : "–", number_text(e.tolerance, "{:.0e}"),
                          e.n_with_bar > 0 ? fmt::format("{} of {}", e.n_covered, e.n_with_bar) : "–", e.name});
  }
  Filling filling{{"template", "verdict"},
                  {"badge", !all             ? "bad"
                            : n_compared > 0 ? "good"
                                             : "maybe"},
                  {"verdict", !all             ? "not confirmed"
                              : n_compared > 0 ? "confirmed"
                                               : "not compared"},
                  {"proof", proof_text(results)}};
  if (results.size() == 1) {
    filling["sentence"] = sentence_of(results.front());
    return filling;
  }
  filling["sentence"] = n_compared == 0
                            ? ""
                            : fmt::format("Finite elements and MDR agree within tolerance in {} of {}.",
                                          static_cast<std::size_t>(n_pass) - n_beyond, counted(n_compared, "case"));
  if (n_beyond > 0)
    filling["sentence"] =
        fmt::format("{}{} not compared, because MDR does not hold for the profile.",
                    n_compared == 0 ? "" : filling["sentence"].get<std::string>() + " ", were(n_beyond));
  filling["has_values"] = true;
  filling["values"] = filling_of(values_table(results, quantities_with_units()));
  filling["table"] = filling_of(table);
  return filling;
}

Filling budget_section(const Results& results) {
  std::map<std::string, std::map<std::string, std::vector<double>>> shares;  // by quantity and source
  std::set<std::string> sources;
  for (const auto& r : results) {
    const auto& fe = r.json.at("fe");
    if (!fe.contains("error_estimate")) continue;
    for (const auto& [quantity, bar] : fe["error_estimate"].items())
      if (bar.is_object() && bar.contains("shares"))
        for (const auto& [source, share] : bar["shares"].items())
          if (share.value("estimate", ordered_json()).is_number()) {
            shares[quantity][source].push_back(share["estimate"].get<double>());
            sources.insert(source);
          }
  }
  if (shares.empty()) return nullptr;
  const bool several = results.size() > 1;
  Table table{{several ? "median, largest" : "share of the bar"}};
  table.heads.insert(table.heads.end(), sources.begin(), sources.end());
  for (const auto quantity : quantities_by_interest) {
    const auto found = shares.find(name_of(quantity));
    if (found == shares.end()) continue;
    std::vector<Cell> row{title_with_scale(quantity)};
    for (const auto& source : sources) {
      auto& values = found->second[source];
      std::sort(values.begin(), values.end());
      const auto share = [](double value) { return value == 0 ? std::string("0") : fmt::format("{:.0e}", value); };
      row.emplace_back(values.empty() ? "–"
                       : several      ? share(values[values.size() / 2]) + ", " + share(values.back())
                                      : share(values.back()));
    }
    table.rows.push_back(std::move(row));
  }
  return {{"template", "budget"}, {"several", several}, {"table", filling_of(table)}};
}

}  // namespace fretval
