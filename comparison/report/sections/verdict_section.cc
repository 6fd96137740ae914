#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "comparison/accuracy/proof.h"
#include "comparison/quantities/quantity.h"
#include "comparison/report/sections/sections.h"
#include "comparison/report/sections/values_table.h"
#include "comparison/report/text/numbers.h"
#include "comparison/report/text/table.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/verdict_text.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using Results = std::vector<StoredResult>;
using nlohmann::ordered_json;

std::string title_with_scale(Quantity quantity) {
  return fmt::format("{} ({})", traits_of(quantity).title, traits_of(quantity).scale.words);
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
      "The answer of the finite elements alone, computed without error bars (--proof none): what it is worth nobody "
      "can tell. ");
  add(Proof::bars,
      "The finite elements have error bars, each source measured by its own refinement, and are taken as they are "
      "(--proof bars). ");
  add(Proof::tolerance,
      "The finite elements have error bars, each source measured by its own refinement, and were refined while the "
      "bars were wider than the tolerance (--proof tolerance). ");
  return text +
         "A quantity agrees where the difference and the error bars of both methods are within the tolerance; it is "
         "not resolved where the bars are wider than that; without error bars nothing is proved.";
}

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(text.front()));
  return text;
}

/// What happens, and the verdict on MDR.
std::string sentence_of(const StoredResult& result) {
  const auto answer = answer_of(result.json);
  return (answer.plain.empty() ? "" : capitalised(answer.plain) + ". ") + capitalised(answer.verdict) + "." +
         (answer.model.empty() ? "" : " " + capitalised(answer.model) + ".");
}

/// Summary of several results.
struct Badge {
  const char *kind, *words;
};

Badge badge_of(const std::map<Outcome, std::size_t>& counts) {
  const auto has = [&](Outcome outcome) { return counts.count(outcome) > 0; };
  if (has(Outcome::disagree)) return {"bad", "not confirmed"};
  if (has(Outcome::not_resolved)) return {"maybe", "not resolved"};
  if (has(Outcome::not_proved)) return {"maybe", "not proved"};
  if (has(Outcome::agree)) return {"good", "confirmed"};
  return {"maybe", has(Outcome::other_model) ? "another model" : "not compared"};
}

/// "In 11 of 13 cases all that was asked for agrees with the method of dimensionality reduction (MDR); 2 not resolved."
std::string counts_sentence(const std::map<Outcome, std::size_t>& counts, std::size_t n) {
  const auto count = [&](Outcome outcome) {
    const auto found = counts.find(outcome);
    return found == counts.end() ? std::size_t{0} : found->second;
  };
  const auto n_compared = n - count(Outcome::not_compared) - count(Outcome::other_model);
  if (n_compared == 0) return "";
  auto text = fmt::format("In {} of {} all that was asked for agrees with the method of dimensionality reduction (MDR)",
                          count(Outcome::agree), counted(n_compared, "case"));
  for (const auto outcome : {Outcome::disagree, Outcome::not_resolved, Outcome::not_proved})
    if (const auto some = count(outcome); some > 0) text += fmt::format("; {}: {}", name_of(outcome), some);
  return text + ".";
}

std::string were(std::size_t n) {
  return counted(n, "case") + (n == 1 ? " is" : " are");
}

}  // namespace

Extreme extreme_of(const Results& results, Quantity quantity) {
  Extreme extreme;
  for (const auto& r : results)
    for (const auto& d : stored_differences(r.json)) {
      if (d.quantity != quantity) continue;
      ++extreme.n_compared;
      extreme.n_asked += d.asked ? 1 : 0;
      if (d.verdict) ++extreme.counts[*d.verdict];
      if (extreme.n_compared > 1 && d.size <= extreme.size) continue;
      extreme.size = d.size;
      extreme.tolerance = d.tolerance;
      extreme.bar = d.bar;
      extreme.name = r.name();
    }
  return extreme;
}

namespace {

/// A row for each quantity: the number of each verdict, and the largest difference with the bar and the tolerance of
/// its case. asked: whether the table is that of the quantities that were asked for, or of the others.
Table table_of_differences(const Results& results, bool asked) {
  Table table{{"quantity", "cases", "agree", "not resolved", "disagree", "largest difference", "its error bar",
               "its tolerance", "in the case"}};
  for (const auto quantity : quantities_by_interest) {
    auto e = extreme_of(results, quantity);
    if (e.n_compared == 0 || (e.n_asked > 0) != asked) continue;
    const auto count = [&](Verdict verdict) { return fmt::format("{}", e.counts[verdict]); };
    table.rows.push_back({title_with_scale(quantity), fmt::format("{}", e.n_compared), count(Verdict::agree),
                          count(Verdict::not_resolved),
                          bad_if(e.counts[Verdict::disagree] > 0, count(Verdict::disagree)), number_text(e.size),
                          number_text(e.bar), number_text(e.tolerance, "{:.0e}"), e.name});
  }
  return table;
}

}  // namespace

Filling verdict_section(const Results& results) {
  std::map<Outcome, std::size_t> counts;
  for (const auto& r : results) ++counts[stored_outcome(r.json)];
  const auto badge = badge_of(counts);
  Filling filling{
      {"template", "verdict"}, {"badge", badge.kind}, {"verdict", badge.words}, {"proof", proof_text(results)}};
  if (results.size() == 1) {
    filling["sentence"] = sentence_of(results.front());
    // That both methods find gross slip confirms nothing else.
    const auto& one = results.front().json;
    if (slides(one.at("fe")) && slides(one.at("mdr"))) {
      filling["badge"] = "maybe";
      filling["verdict"] = "gross slip";
    }
    return filling;
  }
  auto sentence = counts_sentence(counts, results.size());
  const auto add = [&](Outcome outcome, const char* words) {
    if (const auto found = counts.find(outcome); found != counts.end())
      sentence += fmt::format(" {} {}.", were(found->second), words);
  };
  add(Outcome::other_model, "of another model than that of MDR: differences are what MDR is off by");
  add(Outcome::not_compared, "not compared, because MDR does not hold for the profile");
  filling["sentence"] = sentence;
  filling["has_values"] = true;
  filling["values"] = filling_of(values_table(results, quantities_with_units()));
  filling["table"] = filling_of(table_of_differences(results, true));
  if (const auto others = table_of_differences(results, false); !others.rows.empty()) {
    filling["has_others"] = true;
    filling["others"] = filling_of(others);
  }
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
          if (const auto estimate = number_in(share, "estimate")) {
            shares[quantity][source].push_back(*estimate);
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
