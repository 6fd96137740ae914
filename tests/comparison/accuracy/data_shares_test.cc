#include "comparison/accuracy/data_shares.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "comparison/accuracy/verdict.h"
#include "comparison/data/path_table.h"
#include "comparison/reference/mdr_answer.h"
#include "mdr/rheology/prony_fit.h"
#include "tests/comparison/read_case.h"

namespace fretval::data_shares_test {
namespace {

TEST(DataShares, OfDataThatAreTakenAsTheyAreAreNone) {
  const auto input = read_case();
  EXPECT_TRUE(data_variants(input).empty());
  EXPECT_TRUE(data_uncertainties(input, mdr_case(input)).empty());
}

// Forces under prescribed displacements go with the modulus, radii do not.
TEST(DataShares, OfAHardnessAreThoseOfForces) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  const auto open = data_uncertainties(input, mdr_case(input));
  EXPECT_NEAR(open.at(Quantity::normal_force_max), 0.2, 0.02);
  EXPECT_NEAR(open.at(Quantity::stick_radius_shakedown), 0, 1e-9);
}

// Of a standard solid G' alone has all, and a loss that is measured too large makes the body of both too lossy and too
// soft at rest: by what the fit to G' alone gives, the true body is within the bars.
TEST(DataShares, OfModuliThatContradictEachOtherCoverTheBodyOfTheStorageModulus) {
  auto input = read_case();
  auto& body = input.elastomer;
  const mdr::PronyBody known{body.relaxed_modulus, body.branch_moduli, body.branch_times, 0};
  const auto answer_with = [&](const Case& one) {
    const auto mdr = mdr_case(one);
    return mdr_answer(mdr, mdr_normal_response(mdr));
  };
  const auto exact = answer_with(input);
  mdr::ModulusTable table;
  for (int k = -30; k <= 30; ++k) {
    const double frequency = std::pow(10, k / 10.0);
    const auto modulus = mdr::complex_modulus(known, 2 * M_PI * frequency);
    table.frequency.push_back(frequency);
    table.storage.push_back(modulus.real());
    table.loss.push_back(2 * modulus.imag());
  }
  const auto fitted = mdr::fit_prony(table).body;
  body.relaxed_modulus = fitted.relaxed_modulus;
  body.branch_moduli = fitted.branch_moduli;
  body.branch_times = fitted.branch_times;
  body.master_curve = Case::MasterCurve{};
  body.master_curve->frequency = table.frequency;
  body.master_curve->storage = table.storage;
  body.master_curve->loss = table.loss;
  body.master_curve->kramers_kronig = mdr::KramersKronig{{}, {}, {}, 0, 1, 0, true};
  EXPECT_TRUE(data_variants(input).empty());
  body.master_curve->kramers_kronig->consistent = false;
  const auto open = data_uncertainties(input, mdr_case(input));
  const auto found = answer_with(input);
  const double off = std::abs(*found.normal_force_max / *exact.normal_force_max - 1);
  EXPECT_GT(off, 0.02);
  EXPECT_NEAR(open.at(Quantity::normal_force_max), off, 0.1 * off);
}

/// A single pass over an elastic parabola, off by so much normally.
Case pass_with_error(double normal_error) {
  auto input = read_case(elastic_case());
  Case::Path path{{{0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false}, "rig.csv"};
  path.reduction = Case::PathReduction{300'000, 0, normal_error, 0};
  input.motion = motion_along(path);
  return input;
}

// Of a parabola a = sqrt(R d): an error e of d is one of e/(2 d) of a.
TEST(DataShares, OfARecordAreWhatWasLeftOutOfIt) {
  const auto input = pass_with_error(1.2e-6);
  const auto open = data_uncertainties(input, mdr_case(input));
  EXPECT_NEAR(open.at(Quantity::contact_radius_max), 0.005, 2e-4);
  const auto twice = pass_with_error(2.4e-6);
  EXPECT_NEAR(data_uncertainties(twice, mdr_case(twice)).at(Quantity::contact_radius_max), 0.01, 3e-4);
}

// Off by the same everywhere, or apart at the extremes: what rests at its largest value does so in either of them.
TEST(DataVariants, OfARecordAreShiftedAndStretched) {
  auto input = pass_with_error(0);
  input.motion.path->reduction = Case::PathReduction{300'000, 0, 2e-6, 1e-6, 12, 3e-6, 5e-7};
  const auto variants = data_variants(input);
  ASSERT_EQ(variants.size(), 2U);
  for (const auto& [variant, normal, tangential] : {std::tuple{variants[0], 2e-6, 1e-6}, {variants[1], 3e-6, 5e-7}}) {
    ASSERT_EQ(variant.cases.size(), 2U) << variant.what;
    const auto &shifted = *variant.cases[0].motion.path, &stretched = *variant.cases[1].motion.path;
    EXPECT_NEAR(shifted.normal[0], 1e-4 + normal, 1e-15);
    EXPECT_NEAR(shifted.normal[2], 1.2e-4 + normal, 1e-15);
    EXPECT_NEAR(stretched.normal[0], 1e-4 - normal, 1e-15);
    EXPECT_NEAR(stretched.normal[2], 1.2e-4 + normal, 1e-15);
    for (const auto* path : {&shifted, &stretched}) {
      EXPECT_NEAR(path->tangential[0], -tangential, 1e-15);
      EXPECT_NEAR(path->tangential[2], 1e-5 + tangential, 1e-15);
    }
  }
}

// Without this the start of a record that comes close to lifting off would be at rest without contact.
TEST(DataVariants, OfARecordStayInContactAsItDoes) {
  auto input = pass_with_error(2e-6);
  auto path = *input.motion.path;
  path.normal = {1e-6, 1.2e-4, 1.2e-4};
  input.motion = motion_along(path);
  EXPECT_EQ(data_variants(input)[0].cases[1].motion.path->normal[0], 1e-6);
}

// At one depth a shift alone changes the radius: sqrt(1.01) - 1 by what was left out, sqrt(1.02) - 1 by the scatter.
TEST(DataShares, OfARecordAreTheFarthestOfAVariantAndAddUpOverThem) {
  auto input = pass_with_error(0);
  auto path = *input.motion.path;
  path.normal = {1.2e-4, 1.2e-4, 1.2e-4};
  path.reduction = Case::PathReduction{300'000, 0, 1.2e-6, 0, 12, 2.4e-6, 0};
  input.motion = motion_along(path);
  EXPECT_NEAR(data_uncertainties(input, mdr_case(input)).at(Quantity::contact_radius_max), 0.015, 3e-4);
}

// The round trip: cosines, recorded for 12 cycles with noise after an approach, have their radii within what the record
// leaves open.
TEST(DataShares, OfADenseRecordCoverItsCosines) {
  const auto cosines = read_case();
  std::mt19937 engine(4);
  std::normal_distribution<double> noise(0, 0.05);
  std::string rows = "t [s];d [um];u_x [um]\n";
  for (int i = 0; i < 13'400; ++i) {
    const double t = i / 1e3 - 1, angle = 2 * M_PI * t, phase = angle + *cosines.motion.phase * M_PI / 180;
    const auto& motion = cosines.motion;
    const double d = motion.indentation + motion.normal_amplitude * std::cos(angle);
    rows += fmt::format("{:.3f};{:.4f};{:.4f}\n", t, t < 0 ? 140 * t + 120 : 1e6 * d + noise(engine),
                        t < 0 ? 0 : 1e6 * motion.tangential_amplitude * std::cos(phase) + noise(engine));
  }
  const ScratchFolder folder;
  std::replace(rows.begin(), rows.end(), '.', ',');
  folder.write("record.csv", rows);
  const auto begin = valid_case.find("subsection Motion"), end = valid_case.find("end\n", begin);
  const auto text = valid_case.substr(0, begin) +
                    "subsection Motion\nset Path = record.csv\nset Path repeats = forever\n" + valid_case.substr(end);
  const auto record = read_case_file(folder.write("case.prm", text)).at(0);
  EXPECT_EQ(record.motion.path->reduction->n_cycles, 12U);
  EXPECT_NEAR(record.motion.path->duration(), 1, 1e-5);
  const auto mdr = mdr_case(record), exact = mdr_case(cosines);
  const auto read = mdr_answer(mdr, mdr_normal_response(mdr)), known = mdr_answer(exact, mdr_normal_response(exact));
  const auto open = data_uncertainties(record, mdr);
  const double a = *known.contact_radius_max;
  EXPECT_NEAR(*read.contact_radius_max / a, 1, open.at(Quantity::contact_radius_max));
  EXPECT_NEAR(*read.stick_radius_first_slip / a, *known.stick_radius_first_slip / a,
              open.at(Quantity::stick_radius_first_slip));
  EXPECT_NEAR(*read.stick_radius_shakedown / a, *known.stick_radius_shakedown / a,
              open.at(Quantity::stick_radius_shakedown));
  EXPECT_LT(open.at(Quantity::stick_radius_shakedown), 0.02);
}

TEST(DataShares, WidenTheBarButNotWhatTheComparisonDependsOn) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  ErrorBudget budget;
  budget[Quantity::normal_force_max].add(ErrorSource::rings, 1e-3);
  add_data_shares(input, mdr_case(input), budget);
  const auto& bar = budget.at(Quantity::normal_force_max);
  EXPECT_NEAR(bar.total(), 0.2, 0.02);
  EXPECT_EQ(bar.of_numerics(), 1e-3);
  EXPECT_EQ(budget.size(), 1U);
  Difference one{1e-4, 2e-3};
  one.bar = bar;
  EXPECT_EQ(judged(one).verdict, Verdict::agree);
}

}  // namespace
}  // namespace fretval::data_shares_test
