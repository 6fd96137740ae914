#include "comparison/accuracy/error_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval {
namespace {

bool ends_with_contact(const CaseNeeds& needs, Quantity quantity) {
  if (quantity == Quantity::stick_radius_first_slip) return needs.first_slip_ends_with_contact;
  return quantity == Quantity::stick_radius_shakedown && needs.shakedown_ends_with_contact;
}

ExpectedOrder expected_order(ErrorSource source, Quantity quantity, const CaseNeeds& needs) {
  if (source == ErrorSource::time_step && traits_of(quantity).of_settling) return {1};
  if (source == ErrorSource::time_step && needs.held_from_start && traits_of(quantity).of_friction) return {1, 4};
  constexpr double never_believed = 0;
  if (source == ErrorSource::time_step && needs.has_short_branch) return {2, never_believed};
  if (source == ErrorSource::time_step || source == ErrorSource::start || source == ErrorSource::wear_jump) return {2};
  if (source == ErrorSource::creep) return {1};
  if (source == ErrorSource::far_field) return {needs.stretches ? 2.0 : 4.0};
  if (source == ErrorSource::angles) return {2};
  if (source != ErrorSource::rings) return {3};
  if (needs.kind == ContactKind::plane && is_of_stick_zone(quantity)) return {1, 4};
  if (needs.kind == ContactKind::annuli || ends_with_contact(needs, quantity)) return {1, 4};
  const auto& traits = traits_of(quantity);
  constexpr double at_a_worn_edge = 2, of_a_smooth_kernel = 2;
  double order = traits.rings.order;
  if (needs.kind == ContactKind::worn) order = std::min(order, at_a_worn_edge);
  if (needs.ends && traits.of_friction) order = std::min(order, of_a_smooth_kernel);
  return {order};
}

/// The value of a quantity; NaN: it is not there.
double value_of(const Quantities& values, Quantity quantity) {
  const auto found = values.find(quantity);
  return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

double element_error(double difference, unsigned degree, unsigned other) {
  if (other > degree) return 1.25 * difference;
  return 3 * std::pow(difference, static_cast<double>(degree) / other);
}

/// Whether a variant of a given mesh is finer than its reference: in rings and cells, or in its cells alone.
bool is_finer_given_mesh(const Variant& variant) {
  const auto &finer = variant.resolution, &coarser = variant.reference;
  if (variant.source == ErrorSource::rings)
    return coarser.mesh_refinements && finer.elements_per_radius > coarser.elements_per_radius;
  return variant.source == ErrorSource::grading && finer.mesh_refinements > coarser.mesh_refinements;
}

/// Error of a given mesh from the difference to the mesh with its cells split into four. Corners of the body and of its
/// materials have singular stresses; the errors of the quantities have twice their order, and fall at least with the
/// first power of the cells.
double of_a_finer_mesh(double difference) {
  return 2 * difference;
}

constexpr double safety = 1.5;  // of a difference that is one of its kind

/// |C h| + |D h³| of an error C h + D h³, from q(h) - q(2h) and q(2h) - q(4h).
double of_first_and_third_order(double fine, double coarse) {
  return std::abs(coarse - 8 * fine) / 6 + std::abs(coarse - 2 * fine) / 42;
}

/// The error share of a variant; infinite where only some of the computations have the quantity, or where the coarser
/// of two was read without knowing it.
ErrorShare share_of(const Variant& variant, const Refinements& values, Quantity quantity, const CaseNeeds& needs) {
  const auto expected = expected_order(variant.source, quantity, needs);
  const auto source = variant.source;
  const double difference = std::abs(values.fine - values.medium);
  if (std::isnan(difference) || std::isnan(values.coarse.value_or(0)) || std::isinf(values.medium_reading))
    return {source, std::numeric_limits<double>::infinity(), std::nullopt};
  if (source == ErrorSource::element_order)
    return {source, element_error(difference, variant.reference.degree, variant.resolution.degree), std::nullopt};
  if (source == ErrorSource::cycles) return {source, difference, std::nullopt};
  if (is_finer_given_mesh(variant)) return {source, of_a_finer_mesh(difference), std::nullopt};
  if (source == ErrorSource::rings && values.coarse && ends_with_contact(needs, quantity))
    return {source, safety * of_first_and_third_order(values.fine - values.medium, values.medium - *values.coarse),
            std::nullopt};
  if (source == ErrorSource::edge || source == ErrorSource::instants)
    return {source, safety * std::max(difference, std::abs(values.fine - values.coarse.value_or(values.fine))),
            std::nullopt};
  return richardson(source, values, expected);
}

/// The uncertainty of reading a quantity at a resolution; 0: not known.
double uncertainty_of(const std::map<Resolution, Quantities>& readings, const Resolution& resolution,
                      Quantity quantity) {
  const auto reading = readings.find(resolution);
  if (reading == readings.end()) return 0;
  const auto uncertainty = reading->second.find(quantity);
  return uncertainty == reading->second.end() ? 0 : uncertainty->second;
}

/// Leaves out the coarser one of two variants of a source where it could not be computed: the other one is there.
std::vector<Variant> computed_ones(const std::vector<Variant>& variants,
                                   const std::map<Resolution, Quantities>& known) {
  std::vector<Variant> computed;
  for (const auto& variant : variants) {
    const bool is_coarser = !computed.empty() && computed.back().source == variant.source;
    if (!is_coarser || !known.at(variant.resolution).empty()) computed.push_back(variant);
  }
  return computed;
}

/// Leaves out another start for the cycles to shakedown, which are counted from the start that is chosen, and other
/// instants for the largest contact radius: nothing happens at that, and the steps of the answer meet the largest
/// indentation as well as they can.
std::vector<Variant> of_quantity(Quantity quantity, std::vector<Variant> variants) {
  const auto is_left_out = [quantity](const Variant& variant) {
    return (variant.source == ErrorSource::start && quantity == Quantity::cycles_to_shakedown) ||
           (variant.source == ErrorSource::instants && quantity == Quantity::contact_radius_max);
  };
  variants.erase(std::remove_if(variants.begin(), variants.end(), is_left_out), variants.end());
  return variants;
}

}  // namespace

void ErrorBar::add(ErrorSource source, double estimate) {
  const auto found =
      std::find_if(shares.begin(), shares.end(), [source](const auto& share) { return share.source == source; });
  if (found == shares.end())
    shares.push_back({source, estimate, std::nullopt});
  else
    found->estimate += estimate;
}

double ErrorBar::total() const {
  double sum = 0;
  for (const auto& share : shares) sum += share.estimate;
  return sum;
}

double ErrorBar::of_numerics() const {
  double sum = 0;
  for (const auto& share : shares)
    if (share.source != ErrorSource::data) sum += share.estimate;
  return sum;
}

const ErrorShare* ErrorBar::largest() const {
  const auto found = std::max_element(shares.begin(), shares.end(),
                                      [](const auto& a, const auto& b) { return a.estimate < b.estimate; });
  return found == shares.end() ? nullptr : &*found;
}

std::string excess_text(Quantity quantity, const ErrorBar& bar, double tolerance) {
  std::string shares;
  for (const auto& share : bar.shares)
    if (share.estimate > bar.total() / 10)
      shares += fmt::format("{}{} {:.1e}", shares.empty() ? "" : ", ", name_of(share.source), share.estimate);
  return fmt::format("error bar of {} is {:.1e} ({}), {:.1e} is asked for", traits_of(quantity).title, bar.total(),
                     shares, tolerance);
}

ErrorShare richardson(ErrorSource source, const Refinements& values, const ExpectedOrder& expected) {
  const double fine = values.fine - values.medium, gain = std::exp2(expected.order) - 1;
  if (!values.coarse) return {source, 3 * std::abs(fine) / gain, std::nullopt};
  const double coarse = values.medium - *values.coarse;
  const double order = std::log2(coarse / fine);
  if (fine * coarse > 0 && order >= expected.order / 2 && order <= expected.highest)
    return {source, safety * std::abs(fine) / (std::exp2(std::min(order, expected.order)) - 1), order};
  const double whole = std::abs(*values.coarse - values.fine), gain_of_both = std::exp2(2 * expected.order) - 1;
  const double as_read = std::max(std::abs(fine) / gain, whole / gain_of_both),
               at_most = std::max((std::abs(fine) + values.medium_reading) / gain,
                                  (whole - values.coarse_reading) / gain_of_both);
  return {source, 3 * std::min(as_read, at_most), std::nullopt};
}

ErrorBudget error_budget(const Resolution& resolution, const std::map<Resolution, Quantities>& known,
                         const Quantities& edge, const CaseNeeds& needs,
                         const std::map<Resolution, Quantities>& readings) {
  return error_budget(resolution, variants_of(resolution, needs), known, edge, needs, readings);
}

ErrorBar error_bar(Quantity quantity, const std::vector<Variant>& variants, const ChangeOnRefinement& change,
                   const CaseNeeds& needs, const std::map<Resolution, Quantities>& readings) {
  ErrorBar bar;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const auto& [source, varied, reference] = variants[i];
    if (i > 0 && variants[i - 1].source == source) continue;  // the coarser one of two
    const double medium = -change(reference, varied);
    Refinements found{0, medium, std::nullopt};
    if (i + 1 < variants.size() && variants[i + 1].source == source) {
      const auto& coarse = variants[i + 1].resolution;
      found.coarse = medium - change(varied, coarse);
      found.medium_reading = uncertainty_of(readings, varied, quantity);
      found.coarse_reading = uncertainty_of(readings, coarse, quantity);
      if (std::isinf(found.coarse_reading)) found.coarse.reset();
    }
    bar.shares.push_back(share_of(variants[i], found, quantity, needs));
  }
  return bar;
}

ErrorBudget error_budget(const Resolution& resolution, const std::vector<Variant>& variants,
                         const std::map<Resolution, Quantities>& known, const Quantities& edge, const CaseNeeds& needs,
                         const std::map<Resolution, Quantities>& readings) {
  ErrorBudget budget;
  const auto computed = computed_ones(variants, known);
  for (const auto& [quantity, value] : known.at(resolution)) {
    const auto change = [&known, quantity = quantity](const Resolution& finer, const Resolution& coarser) {
      return value_of(known.at(finer), quantity) - value_of(known.at(coarser), quantity);
    };
    auto& bar = budget[quantity] = error_bar(quantity, of_quantity(quantity, computed), change, needs, readings);
    const auto reading = edge.find(quantity);
    if (reading == edge.end()) continue;
    bar.add(quantity == Quantity::contact_radius_max ? ErrorSource::time_step : ErrorSource::edge, reading->second);
  }
  return budget;
}

}  // namespace fretval
