#include "comparison/accuracy/zone_bars.h"

#include <cmath>
#include <limits>

namespace fretval {
namespace {

using Annuli = std::vector<fem::Annulus>;
using Zone = Annuli ZoneAnswer::*;
using End = double fem::Annulus::*;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The answers from which the bars of zones are measured.
struct Measured {
  const Resolution& resolution;
  const Computations& computed;
  const CaseNeeds& needs;

  [[nodiscard]] const ZoneAnswer* at(const Resolution& other) const {
    return computed.failed(other) ? nullptr : computed.at(other).fe.as<ZoneAnswer>();
  }

  /// The error bar of a value that is read from the answer at each resolution. like: quantity whose orders of
  /// convergence it has.
  template <class Value>
  [[nodiscard]] ErrorBar bar_of(Quantity like, const Value& value) const {
    const auto change = [&](const Resolution& finer, const Resolution& coarser) {
      const auto *a = at(finer), *b = at(coarser);
      return a && b ? value(*a) - value(*b) : unknown;
    };
    return error_bar(like, variants_of(resolution, needs), change, needs);
  }
};

std::optional<ErrorBar> end_bar(const Measured& measured, Zone zone, std::size_t k, End end, double uncertainty) {
  const auto n = (measured.at(measured.resolution)->*zone).size();
  const auto quantity = zone == &ZoneAnswer::contact ? Quantity::contact_radius_max : Quantity::stick_radius_shakedown;
  const double length = measured.computed.units().length;
  auto bar = measured.bar_of(quantity, [=](const ZoneAnswer& zones) {
    const auto& annuli = zones.*zone;
    return annuli.size() == n ? annuli[k].*end / length : unknown;
  });
  if (!std::isfinite(bar.total())) return std::nullopt;
  bar.add(ErrorSource::edge, uncertainty / length);
  return bar;
}

std::vector<AnnulusBar> bars_of(const Measured& measured, Zone zone, double uncertainty) {
  const auto& annuli = measured.at(measured.resolution)->*zone;
  std::vector<AnnulusBar> bars;
  for (std::size_t k = 0; k < annuli.size(); ++k) {
    const auto bar = [&](End end) { return end_bar(measured, zone, k, end, uncertainty); };
    bars.push_back({annuli[k].inner > 0 ? bar(&fem::Annulus::inner) : std::nullopt, bar(&fem::Annulus::outer)});
  }
  return bars;
}

double half_a_ring(const Computation& computation, double length) {
  const auto& radii = computation.fe.body->radii;
  return length * radii.back() / (2 * static_cast<double>(radii.size() - 1));
}

}  // namespace

ZoneBudget zone_budget(const Resolution& resolution, const Computations& computed, const CaseNeeds& needs) {
  const Measured measured{resolution, computed, needs};
  const auto& zones = *measured.at(resolution);
  const double half = half_a_ring(computed.at(resolution), computed.units().length);
  return {
      bars_of(measured, &ZoneAnswer::contact, zones.contact_uncertainty),
      bars_of(measured, &ZoneAnswer::first_slip, half), bars_of(measured, &ZoneAnswer::shakedown, half),
      measured.bar_of(Quantity::normal_force_max, [](const ZoneAnswer& one) { return std::log(one.pressure_max); })};
}

}  // namespace fretval
