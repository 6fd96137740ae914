#include "comparison/verification/trade/trade_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fretval {
namespace {

void expect_lines(const std::string& text, const std::vector<std::string>& lines) {
  for (const auto& line : lines) EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nin\n" << text;
}

TEST(TradeText, HasALineForEverythingFound) {
  Trade trade;
  trade.reference.seconds = 2e-7;
  trade.reference.stick_radii_seconds = 8e-8;
  trade.reference.n_repetitions = 10;
  TradePoint coarse, fine;
  coarse.setting.resolution = {8, 2, 2, 12, 24, 1, 1e-6};
  coarse.errors = {{Quantity::stick_radius_shakedown, 3e-3}, {Quantity::normal_force_max, 1e-3}};
  coarse.seconds = {{0.1, 0.2, 0.3}, 0.05, 0.1};
  fine = coarse;
  fine.setting.resolution.elements_per_radius = 48;
  fine.errors[Quantity::stick_radius_shakedown] = 1e-4;
  fine.memory_bytes = 6e6;
  trade.points = {coarse, fine};
  trade.front = {0, 1};
  trade.recommendations = {{1e-2, 0, 1, true}, {1e-5, std::nullopt, 1, false}};
  trade.rates = {{Sweep::rings,
                  {{Quantity::normal_force_max, LogSlope{-2.5, 3}}, {Quantity::contact_radius_max, std::nullopt}},
                  {}}};
  trade.seconds_over_rings = LogSlope{1.25, 4};
  SpringPoint springs;
  springs.setting = {100, 90, 10, 1e-6};
  springs.errors = {{Quantity::stick_radius_shakedown, 2e-4}};
  springs.seconds = 0.25;
  trade.springs = {springs, springs};
  trade.springs[1].failure = "not periodic";
  FullPoint full;
  full.resolution = coarse.setting.resolution;
  full.n_dofs = 1234;
  full.n_normal_steps = 10;
  full.normal_seconds = 2;
  full.pressure_difference = 1e-12;
  trade.full = {{full, 0, 99}, {full, 0, 0}};
  trade.full[1].point.failure = "out of memory";
  const std::string best = "    8     2       2    12     24   3.00e-03     0.750         -";
  const std::string finest = "   48     2       2    12     24   1.00e-03     0.750       6.0";
  const std::string full_line =
      "full finite elements: 8 rings, order 2, 1234 dofs: pressure and traction within 1.0e-12 and 0.0e+00 of the "
      "condensed ones; 0.200 and 0.000 s a step measured";
  expect_lines(
      trade_text(trade),
      {"front        " + best, "front        " + finest, "best 1e-02   " + best, "tool 1e-02   " + finest,
       "best 1e-05: no setting of the plan meets it", "tool 1e-05 ! " + finest,
       "closed form: error 0 by definition, 2.00e-07 s, of which stick radii 8.0e-08 s (fastest of 10)",
       "springs: 100 springs, 90 steps a period: error 2.00e-04, 0.250 s",
       "springs: 100 springs, 90 steps a period: not periodic", full_line,
       "  whole history extrapolated: 99.0 s, error 3.00e-03; condensed: 0.750 s",
       "full finite elements: 8 rings, order 2, 1234 dofs: out of memory",
       std::string("  ") + name_of(Sweep::rings) + "      largest -, contact_radius_max -, normal_force_max -2.50 (3)",
       "power of the seconds in the rings: 1.25 (4)"});
}

}  // namespace
}  // namespace fretval
