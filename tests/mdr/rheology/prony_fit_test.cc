#include "mdr/rheology/prony_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <stdexcept>
#include <string>

#include "mdr/rheology/rheology.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"
#include "tests/mdr/synthetic_table.h"
#include "tests/worse.h"

namespace fretval::mdr::prony_fit_test {
namespace {

const PronyBody known = prony(1e6, {2e6, 5e6, 8e6}, {3.3e-4, 0.0171, 0.71});

using Measure = std::function<double(const Rheology&, double omega)>;

double modulus_size(const Rheology& body, double omega) {
  return std::abs(complex_modulus(body, omega));
}

// Largest relative difference of two bodies over the range of the table.
double difference(const Rheology& a, const Rheology& b, const ModulusTable& table, const Measure& measure) {
  double worst = 0;
  for (const double f : log_spaced(table.frequency.front(), table.frequency.back(), 80)) {
    worst = worse(worst, std::abs(measure(a, 2 * pi * f) / measure(b, 2 * pi * f) - 1));
  }
  return worst;
}

// Roundoff of the moduli, times the condition of the problem, below 1e3.
TEST(PronyFit, RecoversTheModuliOfKnownTimes) {
  PronyFitOptions options;
  options.branch_times = {0.71, 1e-7, 0.0171, 3.3e-4};
  const PronyFit fit = fit_prony(synthetic_table(known, 1e-3, 1e5, 10), options);
  EXPECT_EQ(fit.n_branches_offered, 4);
  EXPECT_LT(difference(fit.body, known, synthetic_table(known, 1e-3, 1e5, 10), modulus_size), 1e-12);
  EXPECT_NEAR(fit.body.relaxed_modulus / 1e6, 1, 1e-12);
  EXPECT_LT(fit.held_out, 1e-12);
}

// Neighbours of a missing time take its place with an error of the spacing of log time squared: 5e-3 and smaller.
TEST(PronyFit, RecoversABodyWhoseTimesAreNotOffered) {
  const ModulusTable table = synthetic_table(known, 1e-3, 1e5, 10);
  const PronyFit fit = fit_prony(table);
  EXPECT_LT(difference(fit.body, known, table, modulus_ratio), 1e-3);
  EXPECT_LT(fit.residual, 1e-3);
  EXPECT_LE(fit.body.branch_times.size(), 6u);  // a pair each; the rest is dropped
}

TEST(PronyFit, MisfitIsTheNoise) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const ModulusTable table = synthetic_table(known, 1e-3, 1e5, 10, 0.02, seed);
    const PronyFit fit = fit_prony(table);
    // 162 values: their scatter is known to 1/sqrt(2 * 162) = 6 %, three of which are allowed.
    EXPECT_NEAR(fit.residual / 0.02, 1, 0.18) << seed;
    EXPECT_NEAR(fit.held_out / 0.02, 1, 0.18) << seed;
    EXPECT_GT(fit.held_out, fit.residual);
    EXPECT_LT(difference(fit.body, known, table, modulus_ratio), 0.02);
  }
}

// The relaxed modulus is above the true one by what relaxes more slowly than was measured, of the order of
// G1 sqrt(omega_min tau) = 2.4 % of G0; within the range |G| itself is as good as the worst misfit.
TEST(PronyFit, FitsTheFractionalZenerBodyOverTwelveDecades) {
  const Rheology body = FractionalZener{1e6, 3e7, 1e-3, 0.5};
  const ModulusTable table = synthetic_table(body, 1e-4, 1e8, 10);
  const PronyFit fit = fit_prony(table);
  EXPECT_LT(fit.residual, 5e-4);
  EXPECT_LT(fit.held_out, 1e-3);
  EXPECT_LT(difference(fit.body, body, table, modulus_size), 1e-3);
  EXPECT_LT(difference(fit.body, body, table, modulus_ratio), 1e-2);
}

TEST(PronyFit, ReportsTheMisfitOfTheBodyItReturns) {
  const ModulusTable table = synthetic_table(known, 1e-3, 1e5, 4, 0.05);
  const PronyFit fit = fit_prony(table);
  double sum = 0, worst = 0, worst_frequency = 0;
  for (std::size_t j = 0; j < table.frequency.size(); ++j) {
    const std::complex<double> modulus = complex_modulus(fit.body, 2 * pi * table.frequency[j]);
    for (const double misfit : {modulus.real() / table.storage[j] - 1, modulus.imag() / table.loss[j] - 1}) {
      sum += misfit * misfit;
      if (std::abs(misfit) <= worst) continue;
      worst = std::abs(misfit);
      worst_frequency = table.frequency[j];
    }
  }
  EXPECT_NEAR(fit.residual, std::sqrt(sum / (2.0 * static_cast<double>(table.frequency.size()))), 1e-12);
  EXPECT_NEAR(fit.worst, worst, 1e-12);
  EXPECT_EQ(fit.worst_frequency, worst_frequency);
}

TEST(PronyFit, NamesThePlaceOfAnOutlier) {
  ModulusTable table = synthetic_table(known, 1e-3, 1e5, 10);
  table.loss[40] *= 2;
  const PronyFit fit = fit_prony(table);
  EXPECT_EQ(fit.worst_frequency, table.frequency[40]);
  EXPECT_NEAR(fit.worst, 0.5, 0.1);
}

TEST(PronyFit, OfTheStorageModulusAloneDoesNotKnowTheLoss) {
  ModulusTable table = synthetic_table(known, 1e-3, 1e5, 4);
  for (double& loss : table.loss) loss *= 2;
  PronyFitOptions options;
  options.branch_times = known.branch_times;
  const PronyFit both = fit_prony(table, options);
  options.storage_alone = true;
  const PronyFit alone = fit_prony(table, options);
  double of_alone = 0, of_both = 0;
  for (std::size_t j = 0; j < table.frequency.size(); ++j) {
    const auto misses = [&](const PronyBody& body) {
      return std::abs(complex_modulus(body, 2 * pi * table.frequency[j]).real() / table.storage[j] - 1);
    };
    of_alone = std::max(of_alone, misses(alone.body));
    of_both = std::max(of_both, misses(both.body));
  }
  EXPECT_LT(of_alone, 1e-8);
  EXPECT_GT(of_both, 0.05);
  EXPECT_GT(alone.residual, 0.3);  // of both: the loss is half of what was measured
}

// Guard: the same table without the dashpot is fitted badly.
TEST(PronyFit, FindsTheDashpotOnlyIfAsked) {
  const ModulusTable table = synthetic_table(prony(1e6, {2e6}, {0.1}, 3e3), 1e-2, 1e4, 6);
  PronyFitOptions options;
  options.branch_times = {0.1};
  EXPECT_EQ(fit_prony(table, options).body.viscosity, 0);
  EXPECT_GT(fit_prony(table, options).residual, 0.1);
  options.dashpot = true;
  EXPECT_NEAR(fit_prony(table, options).body.viscosity / 3e3, 1, 1e-10);
  EXPECT_LT(fit_prony(table, options).residual, 1e-10);
}

TEST(PronyFit, IsIndependentOfUnits) {
  const ModulusTable table = synthetic_table(known, 1e-3, 1e5, 10, 0.02);
  ModulusTable scaled = table;
  for (double& f : scaled.frequency) f *= 1e9;
  for (double& modulus : scaled.storage) modulus *= 1e-8;
  for (double& modulus : scaled.loss) modulus *= 1e-8;
  const PronyFit fit = fit_prony(table), scaled_fit = fit_prony(scaled);
  EXPECT_NEAR(scaled_fit.residual / fit.residual, 1, 1e-9);
  EXPECT_NEAR(scaled_fit.body.relaxed_modulus / fit.body.relaxed_modulus / 1e-8, 1, 1e-9);
}

// More branches a decade than chosen bring less than 5 %, fewer would lose.
TEST(PronyFit, ChoosesTheBranchesByTheHeldOutMisfit) {
  const ModulusTable table = synthetic_table(FractionalZener{1e6, 3e7, 1e-3, 0.5}, 1e-4, 1e8, 10, 0.02);
  const PronyFit chosen = fit_prony(table);
  EXPECT_EQ(chosen.n_branches_offered, 25);  // 2 a decade
  PronyFitOptions options;
  options.branches_per_decade = 1;
  EXPECT_GT(fit_prony(table, options).held_out, 1.05 * chosen.held_out);
  options.branches_per_decade = 4;
  EXPECT_EQ(fit_prony(table, options).n_branches_offered, 49);
  EXPECT_GT(fit_prony(table, options).held_out, 0.95 * chosen.held_out);
}

TEST(PronyFit, NamesTheMissingPlateau) {
  ModulusTable table;
  for (const double f : log_spaced(1e-2, 1e3, 6)) {
    const double x = 2 * pi * f;  // Maxwell body
    table.frequency.push_back(f);
    table.storage.push_back(x * x / (1 + x * x));
    table.loss.push_back(x / (1 + x * x));
  }
  const std::string error = error_of([&] { fit_prony(table); });
  EXPECT_NE(error.find("no relaxed plateau"), std::string::npos) << error;
}

TEST(PronyFit, RejectsBadArguments) {
  const ModulusTable table = synthetic_table(known, 1e-3, 1e5, 2);
  const auto error_with = [&](const PronyFitOptions& options) { return error_of([&] { fit_prony(table, options); }); };
  EXPECT_NE(error_with({0, {}, false}).find("branches per decade = 0: must lie between 1 and 32"), std::string::npos);
  EXPECT_NE(error_with({{}, {1, -1}, false}).find("branch time = -1"), std::string::npos);
  EXPECT_NE(error_with({{}, {1, 2, 1}, false}).find("must be given once"), std::string::npos);
  EXPECT_NE(error_of([] {
              fit_prony({{1, 2, 3, 4}, {1, 1, 1, 1}, {1, 1, 1, 1}});
            }).find("at least 5"),
            std::string::npos);
  EXPECT_THROW(fit_prony({{1, 1, 3, 4, 5}, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::prony_fit_test
