#include "mdr/springs/forced_response.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "mdr/motion/force_control.h"
#include "mdr/springs/repetition.h"
#include "mdr/springs/sampled_peak.h"

namespace fretval::mdr {
namespace {

SpringHistory history_with(const HistoryOfSprings& history, const PronyBody& body, const Prescribed& prescribed,
                           const SpringFineness& coarse, int fineness) {
  const auto repeating = repeating_motion(prescribed.motion, fineness * coarse.n_oscillations);
  const double period = repeating.period();
  const int n_steps = fineness * repeating.steps_with(coarse.steps_per_oscillation),
            n_ramp = std::max(repeating.periods_with(fineness * coarse.n_ramp_periods),
                              fineness * periods_of_creep(body, period));
  try {
    return history(fineness * coarse.n_springs, loading_of(prescribed, repeating, n_ramp * period),
                   {period,
                    n_steps,
                    n_ramp,
                    most_periods_with(n_ramp),
                    periodicity_of(body, coarse.periodicity, fineness),
                    {},
                    prescribed.normal_force || prescribed.tangential_force});
  } catch (GrossSlip& slip) {
    slip.amplitude = amplitude_share(slip.time, n_ramp * period);
    throw;
  }
}

SpringFineness halved(SpringFineness fineness) {
  fineness.n_springs /= 2;
  fineness.steps_per_oscillation /= 2;
  fineness.n_ramp_periods = std::max(1, fineness.n_ramp_periods / 2);
  fineness.n_oscillations /= 2;
  return fineness;
}

// Whether a branch relaxes within a step: its force then follows the mean rate of the step, half a step late, and the
// springs are of first order in time.
bool relaxes_in_a_step(const PronyBody& body, const Prescribed& prescribed, const SpringFineness& fineness) {
  const auto repeating = repeating_motion(prescribed.motion, fineness.n_oscillations);
  const double step = repeating.period() / repeating.steps_with(fineness.steps_per_oscillation);
  const auto& times = body.branch_times;
  return std::any_of(times.begin(), times.end(), [step](double time) { return time < step; });
}

ForcedResponse response_of(const ContactRadius& radius_at, double mu, const SpringHistory& history) {
  const double deepest = sampled_peak(history.indentation, 1);
  NormalResponse normal{sampled_peak(history.normal_force, 1),
                        std::max(sampled_peak(history.normal_force, -1), 0.0),
                        radius_at(history, deepest),
                        {},
                        {},
                        history.indentation,
                        history.normal_force};
  for (const double time : history.time) normal.time.push_back(time - history.time.front());
  const auto &shift = history.tangential_displacement, &pull = history.tangential_force;
  return {std::move(normal),
          {history.depths.first_slip, history.settling_depth},
          deepest,
          sampled_peak(history.axis_pressure, 1),
          (sampled_peak(shift, 1) - sampled_peak(shift, -1)) / 2,
          friction_peak(pull, history.normal_force, mu),
          std::accumulate(pull.begin() + 1, pull.end(), 0.0) / static_cast<double>(pull.size() - 1),
          history.friction_work,
          history.bulk_work,
          history.tangential_work};
}

// Share of the contact radius a, next to it, in which g is above a depth. g goes straight there.
double share_above(double depth, double a, double deepest, const std::function<double(double)>& g) {
  constexpr double beside = 0.01;  // of the radius
  return beside * (deepest - depth) / (g(a) - g((1 - beside) * a));
}

// Share of the tangential force that a spring at the edge makes which sticks as a whole or not at all, where the ring
// around the stick zone is narrower than a spring: sums over springs are of first order then, and go to and fro. Depths
// are those of the image g, as which an indenter on a layer is not pressed in.
double unseen_slip(const ForcedResponse& response, const std::function<double(double)>& g, Eigen::Index n_springs) {
  const auto n = static_cast<double>(n_springs);
  const double a = response.normal.contact_radius_max, ring = share_above(response.depths.shakedown, a, g(a), g);
  return ring * n < 1 ? 1 / n : 0;
}

// Share of the contact radius within which springs let go of the indenter for a part of each period, because the
// dashpot would hold them back, where that is less than a spring: no sum over springs sees what they do not lose. They
// are those whose load would fall below 0, by the rate and by what the branches pull at most.
double unseen_edge(const NormalResponse& normal, const PronyBody& body, const std::function<double(double)>& g,
                   Eigen::Index n_springs) {
  const auto &d = normal.indentation, &time = normal.time;
  const std::size_t n = d.size() - 1;
  if (body.viscosity == 0 || n < 2) return 0;
  const auto [shallowest, deepest] = std::minmax_element(d.begin(), d.end());
  const double viscous = body.viscosity / body.relaxed_modulus / (2 * (time[1] - time[0]));
  double lowest = *shallowest;
  for (std::size_t k = 0; k < n; ++k) lowest = std::min(lowest, d[k] + viscous * (d[k + 1] - d[(k + n - 1) % n]));
  for (const double modulus : body.branch_moduli) lowest -= modulus / body.relaxed_modulus * (*deepest - *shallowest);
  const double share = share_above(lowest, normal.contact_radius_max, *deepest, g);
  return share * static_cast<double>(n_springs) < 1 ? share : 0;
}

SteppedForcedResponse extrapolated_once(const HistoryOfSprings& history, const ContactRadius& radius_at,
                                        const std::function<double(double)>& g, double outer_radius,
                                        const PronyBody& body, double mu, const Prescribed& prescribed,
                                        const SpringFineness& fineness, Springs springs) {
  const auto response_with = [&](const SpringFineness& coarsest, int times) {
    return response_of(radius_at, mu, history_with(history, body, prescribed, coarsest, times));
  };
  const auto middle = response_with(fineness, 1);
  SteppedForcedResponse stepped{response_with(fineness, 2), {}};
  std::optional<ForcedResponse> coarse;
  const bool scatters = body.viscosity > 0;
  if (!scatters || springs == Springs::coupled) coarse = response_with(halved(fineness), 1);
  const bool first_order = relaxes_in_a_step(body, prescribed, fineness);
  const auto extrapolate = [&](auto&& part, double gain = 3) {
    const auto extrapolation = [gain](double coarser, double finer) { return finer + (finer - coarser) / gain; };
    const double fine = part(stepped.response), now = extrapolation(part(middle), fine);
    part(stepped.response) = now;
    const double if_first_order = first_order ? std::max(gain - 1, 1.0) : 1;
    const double difference = (scatters ? 3 : if_first_order) * std::abs(now - fine);
    part(stepped.error) =
        coarse ? std::max(std::abs(now - extrapolation(part(*coarse), part(middle))), difference) : difference;
  };
  extrapolate([](auto& r) -> auto& { return r.normal.normal_force_max; });
  extrapolate([](auto& r) -> auto& { return r.normal.normal_force_min; });
  extrapolate([](auto& r) -> auto& { return r.normal.contact_radius_max; });
  extrapolate([](auto& r) -> auto& { return r.depths.first_slip; });
  extrapolate([](auto& r) -> auto& { return r.depths.shakedown; });
  extrapolate([](auto& r) -> auto& { return r.largest_indentation; });
  extrapolate(
      [](auto& r) -> auto& { return r.axis_pressure_max; }, axis_pressure_gain(g, outer_radius));
  stepped.response.normal.normal_force_error = stepped.error.normal.normal_force_max;
  extrapolate([](auto& r) -> auto& { return r.tangential_amplitude; });
  extrapolate([](auto& r) -> auto& { return r.tangential_force_max; });
  extrapolate([](auto& r) -> auto& { return r.tangential_force_mean; });
  extrapolate([](auto& r) -> auto& { return r.friction_work; });
  extrapolate([](auto& r) -> auto& { return r.bulk_work; });
  extrapolate([](auto& r) -> auto& { return r.tangential_work; });
  const double slip = unseen_slip(stepped.response, g, 2 * fineness.n_springs);
  if (prescribed.tangential_force) {
    stepped.error.tangential_amplitude += slip * stepped.response.tangential_amplitude;
  } else {
    stepped.error.tangential_force_max += slip * stepped.response.tangential_force_max;
    stepped.error.tangential_force_mean += slip * stepped.response.tangential_force_max;
  }
  stepped.error.bulk_work +=
      stepped.response.bulk_work * unseen_edge(stepped.response.normal, body, g, 2 * fineness.n_springs);
  if (has_bounded_axis_pressure(g, outer_radius, body, stepped.response.normal.normal_force_min == 0))
    stepped.response.normal.axis_pressure = {stepped.response.axis_pressure_max, stepped.error.axis_pressure_max};
  return stepped;
}

}  // namespace

double deepest_indentation(const Profile& profile, const PronyBody& body, const Prescribed& prescribed) {
  const double most = maximum_indentation(prescribed.motion);
  return prescribed.normal_force ? indentation_for_force(profile, body.relaxed_modulus, most) : most;
}

double largest_radius(const Profile& profile, const PronyBody& body, const Prescribed& prescribed) {
  constexpr double room = 1.001;
  return std::min(room * inverse_transform(profile, deepest_indentation(profile, body, prescribed)),
                  end_radius(profile));
}

Loading loading_of(const Prescribed& prescribed, const RepeatingMotion& repeating, double ramp_duration) {
  const auto path = ramped_path(repeating, ramp_duration);
  Loading loading{path, {}, {}};
  if (prescribed.normal_force) loading.normal_force = [path](double time) { return path(time).indentation; };
  if (prescribed.tangential_force) loading.tangential_force = [path](double time) { return path(time).tangential; };
  return loading;
}

SteppedForcedResponse extrapolated_response(const HistoryOfSprings& history, const ContactRadius& radius_at,
                                            const std::function<double(double)>& g, double outer_radius,
                                            const PronyBody& body, double mu, const Prescribed& prescribed,
                                            const SpringFineness& fineness, Springs springs) {
  const auto response_with = [&](const SpringFineness& with) {
    return extrapolated_once(history, radius_at, g, outer_radius, body, mu, prescribed, with, springs);
  };
  try {
    return response_with(fineness);
  } catch (const GrossSlip&) {
    constexpr int longer = 5;
    auto slowly = fineness;
    slowly.n_ramp_periods *= longer;
    return response_with(slowly);
  }
}

SteppedForcedResponse forced_response(const Profile& profile, const PronyBody& body, double mu,
                                      const Prescribed& prescribed, const SpringFineness& fineness) {
  const double outer = largest_radius(profile, body, prescribed);
  return extrapolated_response(
      [&](Eigen::Index n, const Loading& loading, const HistoryControl& control) {
        return spring_history(spring_bed(profile, outer, n), body, mu, loading, control);
      },
      [&](const SpringHistory& /*history*/, double depth) { return inverse_transform(profile, depth); },
      [&](double x) { return transform(profile, x); }, outer, body, mu, prescribed, fineness);
}

SteppedForcedResponse forced_response(const LimitingProfile& worn, const PronyBody& body, double mu,
                                      const Prescribed& prescribed) {
  const auto g = [&worn](double x) { return transform(worn, x); };
  return extrapolated_response(
      [&](Eigen::Index n, const Loading& loading, const HistoryControl& control) {
        return spring_history(spring_bed(g, worn.stick_radius, n), body, mu, loading, control);
      },
      [&](const SpringHistory& /*history*/, double /*depth*/) { return worn.stick_radius; }, g, worn.stick_radius, body,
      mu, prescribed);
}

}  // namespace fretval::mdr
