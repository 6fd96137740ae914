#include "mdr/layer/layer_slip.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>

#include "mdr/profiles/indentation.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"
#include "tests/mdr/layer/layer_waves.h"

namespace fretval::mdr::layer_slip_test {
namespace {

const double mu = 0.4, G = 3;

TEST(LayerSlip, OfAThickLayerIsCattaneosAndMindlins) {
  for (const Profile& profile : {parabola(1), cone(0.3), rounded_flat(0.4, 1)}) {
    const double c = 0.6, d = transform(profile, 1.0);
    const LayerPush push = layer_push_to_radius(layer_contact(profile, {1e6, 0.5}, 1), mu, G, c);
    const double u = 1.5 * mu * (d - transform(profile, c));
    EXPECT_NEAR(push.tangential_displacement / u, 1, 1e-5);  // a/H and its likes
    EXPECT_NEAR(push.tangential_force / tangential_force_cattaneo_mindlin(profile, G, mu, d, u), 1, 1e-5);
  }
  const LayerPush compressible = layer_push_to_radius(layer_contact(parabola(1), {1e6, 0}, 1), mu, G, 0.6);
  EXPECT_NEAR(compressible.tangential_displacement, mu * 0.64, 1e-5);
}

TEST(LayerSlip, DisplacementAndForceFindTheirRadius) {
  for (const Layer& layer : {Layer{2, 0.5}, Layer{0.5, 0.5}, Layer{0.5, 0.2}}) {
    const LayerContact contact = layer_contact(parabola(1), layer, 1);
    for (const double c : {0.1, 0.5, 0.97}) {
      const LayerPush push = layer_push_to_radius(contact, mu, G, c);
      EXPECT_NEAR(layer_push(contact, mu, G, push.tangential_displacement)->stick_radius, c, 1e-10);
      EXPECT_NEAR(layer_push_under_force(contact, mu, G, push.tangential_force)->stick_radius, c, 1e-10);
    }
    EXPECT_FALSE(layer_push(contact, mu, G, 10));
    EXPECT_FALSE(layer_push_under_force(contact, mu, G, mu * normal_force(contact, G)));
    EXPECT_TRUE(layer_push_under_force(contact, mu, G, 0.999 * mu * normal_force(contact, G)));
    EXPECT_EQ(layer_push(contact, mu, G, 0)->stick_radius, 1);
  }
}

// dF_x/du_x at the very start is the stiffness of a punch that sticks all over.
TEST(LayerSlip, BeginsAsAPunchThatSticks) {
  const Layer layer{0.7, 0.45};
  const LayerContact contact = layer_contact(parabola(1), layer, 1);
  const LayerPush push = layer_push_to_radius(contact, mu, G, 0.999);
  EXPECT_NEAR(push.tangential_force / push.tangential_displacement /
                  punch_stiffness(layer_punch(layer, Direction::tangential, 1), G),
              1, 3e-3);  // 1-c/a and its square
}

// The three-dimensional layer under the traction of a push: the half-space's mean displacement by elliptic integrals,
// what the layer changes by Hankel transforms of the responses that the matrix exponential gives. G = 1, mu = 1.
class PushedLayer {
 public:
  PushedLayer(const LayerContact& contact, double c)
      : contact_(contact), c_(c), row_(contact.profile, contact.layer, c, contact.contact_radius) {
    const LayerKernel& kernel = row_.row().kernel();
    sliding_ = amplitudes(kernel, contact.rule.point, contact.rule.weight * contact.at_points);
    held_ = row_.row().amplitudes_of(row_.held(contact).at_points);
  }

  // tau = p less what s makes of it, whose slope is taken between neighbours.
  [[nodiscard]] double traction(double r) const {
    double tau = pressure(contact_, 1, r);
    if (r >= c_) return tau;
    const double end = std::sqrt((c_ - r) * (c_ + r)), h = 1e-4;
    const QuadratureRule rule = gauss_legendre({0, end / 2, end}, 12);
    for (Eigen::Index j = 0; j < rule.point.size(); ++j) {
      const double x = std::hypot(r, rule.point[j]);
      tau += modulus_ / pi * rule.weight[j] * (held_load(x + h) - held_load(std::abs(x - h))) / (2 * h) / x;
    }
    return tau;
  }

  [[nodiscard]] double displacement(double r) const {
    const double nu = contact_.layer.poisson_ratio, a = contact_.contact_radius;
    boost::math::quadrature::tanh_sinh<double> singular;
    const auto ring = [&](double s) {
      return traction(s) * s / (r + s) * boost::math::ellint_1(std::min(2 * std::sqrt(r * s) / (r + s), 1 - 1e-16));
    };
    std::vector<double> cuts{0, c_, a};
    if (r > 0) cuts.insert(std::upper_bound(cuts.begin(), cuts.end(), r), r);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) sum += singular.integrate(ring, cuts[i], cuts[i + 1], 1e-5);
    sum *= (2 - nu) / pi;
    const double middle = std::asin(c_ / a);
    const QuadratureRule angle = gauss_legendre({0, 0.7 * middle, middle, pi / 2}, 16),
                         waves = gauss_legendre({0, 1, 2, 4, 8}, 12);
    const Eigen::ArrayXd s = a * angle.point.sin(), share = angle.weight * a * angle.point.cos() * s *
                                                            s.unaryExpr([this](double at) { return traction(at); });
    for (Eigen::Index m = 0; m < waves.point.size(); ++m) {
      const double k = waves.point[m] / contact_.layer.thickness;
      const LayerWaves layer = layer_waves(contact_.layer, k);
      const double transformed =
          (share * s.unaryExpr([k](double at) { return boost::math::cyl_bessel_j(0, k * at); })).sum();
      sum += waves.weight[m] / contact_.layer.thickness * ((layer.along + layer.across) * k - (2 - nu)) / 2 *
             transformed * boost::math::cyl_bessel_j(0, k * r);
    }
    return sum;
  }

 private:
  // s(x) + D, as the row says it.
  [[nodiscard]] double held_load(double x) const {
    const LayerKernel& kernel = row_.row().kernel();
    return spring_load(contact_, x) + coupling(kernel, sliding_, x) - coupling(kernel, held_, x);
  }

  const LayerContact& contact_;
  double c_;
  StickRow row_;
  Eigen::ArrayXd sliding_, held_;
  double modulus_ = spring_modulus(Direction::normal, contact_.layer.poisson_ratio);
};

// Uniform where it sticks, less beyond; the traction has a root at c, which limits the transforms to some 1e-5.
TEST(LayerSlip, MovesTheSurfaceAsOneWhereItSticks) {
  const double c = 0.6;
  for (const Layer& layer : {Layer{1, 0.5}, Layer{0.7, 0.3}}) {
    const LayerContact contact = layer_contact(parabola(1), layer, 1);
    const double u = layer_push_to_radius(contact, 1, 1, c).tangential_displacement;
    const PushedLayer pushed(contact, c);
    EXPECT_NEAR(pushed.displacement(0) / u, 1, 3e-5);
    EXPECT_NEAR(pushed.displacement(0.4) / u, 1, 3e-5);
    EXPECT_LT(pushed.displacement(0.8) / u, 0.97);
  }
}

// Springs beyond c lag behind the indenter, and the more the farther out: slip is to one side.
TEST(LayerSlip, SlipsOneWay) {
  const LayerContact contact = layer_contact(parabola(1), {0.3, 0.5}, 1);
  const StickRow row(parabola(1), {0.3, 0.5}, 0.6, 1);
  const auto held = row.held(contact);
  EXPECT_GT(held.at_points.minCoeff(), 0);
  EXPECT_GT(slip_reach(row, contact).depth, 0);
  EXPECT_GT(slip_reach(row, contact).load, 0);
}

TEST(LayerSlip, RejectsBadArguments) {
  const LayerContact contact = layer_contact(parabola(1), {1, 0.5}, 1);
  EXPECT_NE(error_of([&] { layer_push_to_radius(contact, mu, G, 1.1); }).find("stick radius"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_push(contact, 0, G, 1); }).find("friction"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_push_under_force(contact, mu, G, -1); }).find("force"), std::string::npos);
  const LayerContact sliding = layer_contact(parabola(1), {1, 0.5, LayerBase::frictionless}, 1);
  EXPECT_NE(error_of([&] { layer_push(sliding, mu, G, 0.1); }).find("frictionless"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_slip_test
