#include "mdr/motion/mean_cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretval::mdr {

namespace {

using Values = std::vector<double>;

constexpr std::size_t n_samples = 4000, most_parts = 240, least_cycle_rows = 16;
constexpr double largest_departure = 0.1;  // of the variance

double mean_of(const Values& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The values less their mean, over their standard deviation; zeros for a constant.
Values normalised(Values values) {
  const double mean = mean_of(values);
  double squares = 0;
  for (double& value : values) {
    value -= mean;
    squares += value * value;
  }
  const double deviation = std::sqrt(squares / static_cast<double>(values.size()));
  for (double& value : values) value = deviation > 1e-9 * std::abs(mean) ? value / deviation : 0;
  return values;
}

/// Whether a signal is constant or mostly noise, so that it shows no period.
bool is_noise(const Values& normalised_values) {
  constexpr double mostly = 0.5;  // of the standard deviation
  const bool is_constant =
      std::all_of(normalised_values.begin(), normalised_values.end(), [](double v) { return v == 0; });
  return is_constant || white_noise_of(normalised_values) > mostly;
}

/// A signal at n equally spaced instants: at each the mean of the rows around it or, where there are none, a value
/// between those of its neighbours.
Values resampled(const Values& time, const Values& values, std::size_t n) {
  Values sums(n), counts(n);
  const double duration = time.back() - time.front();
  for (std::size_t i = 0; i < time.size(); ++i) {
    const auto place = static_cast<std::size_t>((time[i] - time.front()) / duration * static_cast<double>(n));
    sums[std::min(place, n - 1)] += values[i];
    ++counts[std::min(place, n - 1)];
  }
  std::size_t row = 1;
  for (std::size_t k = 0; k < n; ++k) {
    if (counts[k] > 0) {
      sums[k] /= counts[k];
      continue;
    }
    const double t = time.front() + (static_cast<double>(k) + 0.5) * duration / static_cast<double>(n);
    while (row + 1 < time.size() && time[row] < t) ++row;
    const double share = (t - time[row - 1]) / (time[row] - time[row - 1]);
    sums[k] = values[row - 1] + share * (values[row] - values[row - 1]);
  }
  return sums;
}

/// Mean square of the difference of signals from themselves, shifted, over twice their variance.
double departure(const std::vector<Values>& signals, std::size_t shift) {
  double sum = 0;
  std::size_t n = 0;
  for (const auto& signal : signals)
    for (std::size_t i = 0; i + shift < signal.size(); ++i, ++n) {
      const double difference = signal[i + shift] - signal[i];
      sum += difference * difference;
    }
  return sum / (2 * static_cast<double>(n));
}

/// The place of the lowest point of a parabola through three points one apart, from the middle one.
double lowest_between(double before, double at, double after) {
  const double curvature = before - 2 * at + after;
  return curvature > 0 ? std::clamp((before - after) / (2 * curvature), -1.0, 1.0) : 0;
}

/// Period of signals in samples.
std::optional<double> period_of(const std::vector<Values>& signals) {
  const std::size_t n = signals.front().size(), longest = n * 3 / 4;
  Values by_shift;
  for (std::size_t shift = 0; shift <= longest; ++shift) by_shift.push_back(departure(signals, shift));
  const auto rise = std::find_if(by_shift.begin(), by_shift.end(), [](double d) { return d > 4 * largest_departure; });
  if (rise == by_shift.end()) return std::nullopt;
  const double least = *std::min_element(rise, by_shift.end());
  if (least > largest_departure) return std::nullopt;
  // The first minimum that is about as low as any: other ones are multiples of it.
  const double low_enough = std::max(3 * least, 1e-3);
  for (auto shift = static_cast<std::size_t>(rise - by_shift.begin()); shift < longest; ++shift) {
    if (by_shift[shift] > low_enough || by_shift[shift] > by_shift[shift - 1] || by_shift[shift] > by_shift[shift + 1])
      continue;
    double period =
        static_cast<double>(shift) + lowest_between(by_shift[shift - 1], by_shift[shift], by_shift[shift + 1]);
    for (std::size_t k = 2; static_cast<double>(k) * period < static_cast<double>(longest); k *= 2) {
      const auto at = static_cast<std::size_t>(std::lround(static_cast<double>(k) * period));
      if (at + 1 > longest) break;
      period = (static_cast<double>(at) + lowest_between(by_shift[at - 1], by_shift[at], by_shift[at + 1])) /
               static_cast<double>(k);
    }
    return period;
  }
  return std::nullopt;
}

/// Means of the rows of each part of each cycle.
struct Parts {
  std::size_t n_parts, n_cycles;
  Values count, phase, normal, tangential;  // part by part, cycle by cycle
  [[nodiscard]] std::size_t at(std::size_t part, std::size_t cycle) const { return part * n_cycles + cycle; }
};

Parts parts_of(const Record& record, double begin, double period, std::size_t n_cycles, std::size_t n_parts) {
  Parts parts{n_parts, n_cycles, Values(n_parts * n_cycles), {}, {}, {}};
  parts.phase = parts.normal = parts.tangential = parts.count;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double cycles = (record.time[i] - begin) / period;
    if (cycles < 0 || cycles >= static_cast<double>(n_cycles)) continue;
    const double phase = cycles - std::floor(cycles);
    const auto part = std::min(static_cast<std::size_t>(phase * static_cast<double>(n_parts)), n_parts - 1);
    const auto at = parts.at(part, static_cast<std::size_t>(cycles));
    ++parts.count[at];
    parts.phase[at] += phase;
    parts.normal[at] += record.normal[i];
    parts.tangential[at] += record.tangential[i];
  }
  for (std::size_t at = 0; at < parts.count.size(); ++at)
    if (parts.count[at] > 0)
      for (auto* values : {&parts.phase, &parts.normal, &parts.tangential}) (*values)[at] /= parts.count[at];
  return parts;
}

struct Statistics {
  Values means;    ///< of each part, over the cycles from the first one on
  double scatter;  ///< root mean square
};

Statistics statistics_of(const Parts& parts, const Values& values, std::size_t first) {
  Statistics all{Values(parts.n_parts), 0};
  double squares = 0, n_free = 0;
  for (std::size_t part = 0; part < parts.n_parts; ++part) {
    double sum = 0, n = 0;
    for (std::size_t cycle = first; cycle < parts.n_cycles; ++cycle)
      if (parts.count[parts.at(part, cycle)] > 0) {
        sum += values[parts.at(part, cycle)];
        ++n;
      }
    if (n == 0) continue;
    all.means[part] = sum / n;
    for (std::size_t cycle = first; cycle < parts.n_cycles; ++cycle)
      if (parts.count[parts.at(part, cycle)] > 0)
        squares += std::pow(values[parts.at(part, cycle)] - all.means[part], 2);
    n_free += n - 1;
  }
  all.scatter = n_free > 0 ? std::sqrt(squares / n_free) : 0;
  return all;
}

/// Share of the period by which cycles lag behind their mean more from one to the next, which is by how much the period
/// is too short.
double lag_per_cycle(const Parts& parts, std::size_t first) {
  constexpr double least_scatter = 1e-6;  // of the range
  const std::size_t n = parts.n_parts, apart = std::max<std::size_t>(n / 40, 1);
  const double middle = static_cast<double>(first + parts.n_cycles - 1) / 2;
  const auto phases = statistics_of(parts, parts.phase, first).means;
  double moments = 0, weights = 0;
  for (const auto* values : {&parts.normal, &parts.tangential}) {
    const auto [means, scatter] = statistics_of(parts, *values, first);
    const auto [least, most] = std::minmax_element(means.begin(), means.end());
    if (*least == *most) continue;
    const double weight = 1 / std::pow(std::max(scatter, least_scatter * (*most - *least)), 2);
    for (std::size_t part = 0; part < n; ++part) {
      const double slope = (means[(part + apart) % n] - means[(part + n - apart) % n]) * static_cast<double>(n) /
                           static_cast<double>(2 * apart);
      for (std::size_t cycle = first; cycle < parts.n_cycles; ++cycle) {
        const auto at = parts.at(part, cycle);
        if (parts.count[at] == 0) continue;
        const double later = static_cast<double>(cycle) - middle;
        // Rows of a part lie at other phases in each cycle.
        moments -= weight * later * slope * ((*values)[at] - means[part] - slope * (parts.phase[at] - phases[part]));
        weights += weight * later * later * slope * slope;
      }
    }
  }
  return weights > 0 ? moments / weights : 0;
}

/// Mean square distance of a cycle from the mean of the second half of them, over the ranges of the signals.
double distance_of(const Parts& parts, std::size_t cycle,
                   const std::vector<std::pair<const Values*, Values>>& signals) {
  double sum = 0, n = 0;
  for (const auto& [values, means] : signals) {
    const auto [least, most] = std::minmax_element(means.begin(), means.end());
    const double range = *most - *least;
    for (std::size_t part = 0; range > 0 && part < parts.n_parts; ++part)
      if (parts.count[parts.at(part, cycle)] > 0) {
        sum += std::pow(((*values)[parts.at(part, cycle)] - means[part]) / range, 2);
        ++n;
      }
  }
  return n > 0 ? sum / n : 0;
}

/// The first cycle that is like those of the second half.
std::size_t first_alike(const Parts& parts) {
  const std::size_t half = parts.n_cycles / 2;
  const std::vector<std::pair<const Values*, Values>> signals{
      {&parts.normal, statistics_of(parts, parts.normal, half).means},
      {&parts.tangential, statistics_of(parts, parts.tangential, half).means}};
  constexpr double times = 100, always = 1e-4;  // of squares
  double usual = always;
  for (std::size_t cycle = half; cycle < parts.n_cycles; ++cycle)
    usual = std::max(usual, times * distance_of(parts, cycle, signals));
  std::size_t first = half;
  while (first > 0 && distance_of(parts, first - 1, signals) <= usual) --first;
  return first;
}

/// Whole cycles up to the end of the record, from the first one on that is like the others.
struct Cycles {
  Parts parts;
  std::size_t first;
  double begin, period;
};

std::optional<Cycles> cycles_of(const Record& record, double period) {
  const double duration = record.time.back() - record.time.front(),
               step = duration / static_cast<double>(record.time.size() - 1);
  const auto n_cycles = static_cast<std::size_t>((duration + step) / period * (1 + 1e-9));
  if (n_cycles < 2 || period / step < static_cast<double>(least_cycle_rows)) return std::nullopt;
  const auto n_parts = std::min(most_parts, static_cast<std::size_t>(period / step));
  const double end = record.time.back() + step / 2;
  auto parts = parts_of(record, end - static_cast<double>(n_cycles) * period, period, n_cycles, n_parts);
  const auto first = std::min(first_alike(parts), n_cycles - 2);
  return Cycles{std::move(parts), first, end - static_cast<double>(n_cycles - first) * period, period};
}

/// Gauss-Newton for the period with which cycles differ least.
std::optional<Cycles> refined(const Record& record, std::optional<Cycles> cycles) {
  constexpr int n_rounds = 4;
  constexpr double largest_lag = 0.1;  // of a period, over all cycles
  for (int round = 0; cycles && round < n_rounds; ++round) {
    const double lag = lag_per_cycle(cycles->parts, cycles->first);
    if (std::abs(lag) * static_cast<double>(cycles->parts.n_cycles - cycles->first) > largest_lag) break;
    auto next = cycles_of(record, cycles->period * (1 + lag));
    if (!next) break;
    cycles = std::move(next);
  }
  return cycles;
}

}  // namespace

std::optional<MeanCycle> mean_cycle(const Record& record) {
  const std::size_t n = record.time.size();
  if (n < 2 * least_cycle_rows) return std::nullopt;
  const auto half = static_cast<std::ptrdiff_t>(n / 2);
  // Half a record may be less than two cycles; then all of it is looked at.
  std::optional<double> period;
  for (const auto from : {half, std::ptrdiff_t{0}}) {
    const auto tail = [from](const Values& values) { return Values(values.begin() + from, values.end()); };
    const auto time = tail(record.time);
    const std::size_t n_of_part = std::min(time.size(), n_samples);
    std::vector<Values> signals;
    for (const auto* values : {&record.normal, &record.tangential})
      if (auto signal = normalised(resampled(time, tail(*values), n_of_part)); !is_noise(signal))
        signals.push_back(std::move(signal));
    const auto found = signals.empty() ? std::nullopt : period_of(signals);
    if (!found) continue;
    period = *found * (time.back() - time.front()) / static_cast<double>(n_of_part);
    break;
  }
  if (!period) return std::nullopt;
  const auto cycles = refined(record, cycles_of(record, *period));
  if (!cycles) return std::nullopt;
  const auto& [parts, first, begin, refined_period] = *cycles;
  const auto normal = statistics_of(parts, parts.normal, first),
             tangential = statistics_of(parts, parts.tangential, first);
  const auto phase = statistics_of(parts, parts.phase, first);
  MeanCycle mean{{}, parts.n_cycles - first, 0, normal.scatter, tangential.scatter};
  for (const double t : record.time) mean.n_before += t < begin;
  for (std::size_t part = 0; part < parts.n_parts; ++part) {
    if (phase.means[part] == 0 && normal.means[part] == 0) continue;  // without a row
    mean.cycle.time.push_back((phase.means[part] - phase.means[0]) * refined_period);
    mean.cycle.normal.push_back(normal.means[part]);
    mean.cycle.tangential.push_back(tangential.means[part]);
  }
  mean.cycle.time.push_back(refined_period);
  mean.cycle.normal.push_back(mean.cycle.normal.front());
  mean.cycle.tangential.push_back(mean.cycle.tangential.front());
  return mean;
}

}  // namespace fretval::mdr
