#include "mdr/profiles/naive_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace fretval::mdr::naive_contact_test {
namespace {

/// A parabola of radius 1 with something on it.
template <class Extra>
Profile table(const Extra& extra) {
  std::vector<double> r, f;
  for (int i = 0; i <= 200; ++i) {
    r.push_back(i * 0.01);
    f.push_back(r.back() * r.back() / 2 + extra(r.back()));
  }
  return tabulated_as_it_is(r, f);
}

// Hertz: F = 16/3 G sqrt(R) d^(3/2), a = sqrt(R d).
TEST(NaiveContact, IsMdrWhereTheImageRises) {
  for (const auto& profile : {parabola(1), table([](double) { return 0.0; })}) {
    const auto contact = naive_contact(profile, 0.5);
    EXPECT_NEAR(contact.force_over_modulus, 16.0 / 3 * std::pow(0.5, 1.5), 1e-7);
    EXPECT_NEAR(contact.radius, std::sqrt(0.5), 1e-7);
    EXPECT_TRUE(falls_of_image(profile).empty());
  }
}

// A groove in between: the springs under it do not reach.
TEST(NaiveContact, LeavesOutSpringsThatDoNotReach) {
  const auto profile = table([](double r) {
    return r > 0.4 && r < 0.7 ? 0.2 * std::pow(std::sin(std::acos(-1.0) * (r - 0.4) / 0.3), 2) : 0.0;
  });
  const auto falls = falls_of_image(profile);
  ASSERT_FALSE(falls.empty());
  EXPECT_GT(falls.front().from, 0.39);
  EXPECT_LT(falls.front().to, 0.75);
  const auto contact = naive_contact(profile, 0.5), smooth = naive_contact(parabola(1), 0.5);
  EXPECT_LT(contact.force_over_modulus, 0.99 * smooth.force_over_modulus);
  // By a midpoint rule of its own.
  double sum = 0;
  for (int i = 0; i < 100000; ++i) sum += std::max(0.5 - transform(profile, (i + 0.5) * 2e-5), 0.0) * 2e-5;
  EXPECT_NEAR(contact.force_over_modulus, 8 * sum, 1e-6);
}

// A hollow indenter, the ridge at r = 1: the image begins at the height of the middle, and falls from there.
TEST(NaiveContact, OfAHollowIndenterBeginsAtItsMiddle) {
  std::vector<double> r, f;
  for (int i = 0; i <= 200; ++i) {
    r.push_back(i * 0.01);
    f.push_back(3 + (r.back() - 1) * (r.back() - 1));
  }
  const auto profile = tabulated_as_it_is(r, f);
  EXPECT_NEAR(shape(profile, 1), 0, 1e-15);
  EXPECT_NEAR(transform(profile, 0), 1, 1e-15);
  // f = 1 - 2 r + r^2: g = 1 - pi x + 2 x^2.
  for (const double x : {0.3, 0.9, 1.7}) EXPECT_NEAR(transform(profile, x), 1 - std::acos(-1.0) * x + 2 * x * x, 1e-9);
  ASSERT_EQ(falls_of_image(profile).size(), 1U);
  EXPECT_NEAR(falls_of_image(profile).front().to, std::acos(-1.0) / 4, 0.01);
  EXPECT_THROW(inverse_transform(profile, 0.1), std::invalid_argument);
  EXPECT_THROW(transform_integral(profile, 0.1), std::invalid_argument);
  EXPECT_THROW(tabulated(r, f), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::naive_contact_test
