#include "mdr/wear/abel_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::abel_matrices_test {
namespace {

const double R = 2, G = 3, d = 0.32, a = 0.8;  // a^2 = R d

SpringBed bed_to(double outer, Eigen::Index n) {
  return spring_bed(parabola(R), outer, n);
}

SpringBed uneven_bed() {
  SpringBed bed = bed_to(1, 4);
  bed.width << 0.1, 0.4, 0.2, 0.3;
  bed.position << 0.05, 0.3, 0.6, 0.85;
  return bed;
}

// Hertz: p = 8 G/(pi R) sqrt(a^2-r^2), integrated over the rings.
Eigen::ArrayXd hertz_ring_means(const SpringBed& bed, const Eigen::ArrayXd& area) {
  const auto beyond = [](double r) { return std::pow(std::max(a * a - r * r, 0.0), 1.5); };
  const Eigen::ArrayXd inner = (bed.position - bed.width / 2).unaryExpr(beyond);
  const Eigen::ArrayXd outer = (bed.position + bed.width / 2).unaryExpr(beyond);
  return 16 * G / (3 * R) * (inner - outer) / area;
}

double order(const std::function<double(Eigen::Index)>& error) {
  return std::log2(error(40) / error(160)) / 2;
}

TEST(AbelMatrices, ImageOfAParabola) {
  const auto error = [](Eigen::Index n) {
    const SpringBed bed = bed_to(1, n);
    const Eigen::VectorXd f = (bed.position.square() / (2 * R)).matrix();
    return ((abel_matrices(bed).image * f).array() - bed.depth).abs().maxCoeff();
  };
  EXPECT_LT(error(40), 0.002 / R);  // of g <= 1/R
  EXPECT_GT(order(error), 1.4) << error(40) << " " << error(160);
}

TEST(AbelMatrices, SurfaceOfAParabola) {
  const auto error = [](Eigen::Index n) {
    const SpringBed bed = bed_to(1, n);
    const Eigen::ArrayXd f = bed.position.square() / (2 * R);
    return ((abel_matrices(bed).displacement * bed.depth.matrix()).array() - f).abs().maxCoeff();
  };
  EXPECT_LT(error(40), 0.0015 / R);
  EXPECT_GT(order(error), 1.4) << error(40) << " " << error(160);
}

TEST(AbelMatrices, PressureOfHertz) {
  const auto error = [](Eigen::Index n) {
    const SpringBed bed = bed_to(1.25 * a, n);  // 40 and 160: the edge of contact is one of an interval
    const AbelMatrices matrices = abel_matrices(bed);
    const Eigen::VectorXd q = 4 * G * (d - bed.depth).max(0).matrix();
    return ((matrices.stress * q).array() - hertz_ring_means(bed, matrices.area)).abs().maxCoeff() /
           (8 * G / (pi * R) * a);
  };
  EXPECT_LT(error(40), 0.05);  // on the last ring, where the pressure is a root
  EXPECT_GT(order(error), 0.45) << error(40) << " " << error(160);
}

// Exact, as the load is constant per interval: p = q/(pi sqrt(a^2-r^2)).
TEST(AbelMatrices, PressureOfAFlatPunch) {
  const SpringBed bed = bed_to(1, 50);
  const AbelMatrices matrices = abel_matrices(bed);
  const double edge = 0.6, q = 4 * G * d;
  const Eigen::ArrayXd stress = (matrices.stress * (bed.position < edge).select(q, Eigen::ArrayXd::Zero(50)).matrix());
  for (Eigen::Index i = 0; i < 50; ++i) {
    const auto within = [&](double r) { return 2 * q * std::sqrt(std::max(edge * edge - r * r, 0.0)); };
    const double inner = bed.position[i] - 0.01, outer = bed.position[i] + 0.01;
    // The root at the edge turns roundoff of the position, 1e-16, into 1e-8.
    EXPECT_NEAR(stress[i] * matrices.area[i], within(inner) - within(outer), 1e-7 * q) << i;
  }
}

TEST(AbelMatrices, SurfaceBesideAFlatPunch) {
  const auto error = [](Eigen::Index n) {
    const SpringBed bed = bed_to(1, n);
    const double edge = 0.5;
    const Eigen::VectorXd u = (bed.position < edge).select(d, Eigen::ArrayXd::Zero(n)).matrix();
    const Eigen::ArrayXd exact =
        bed.position.unaryExpr([&](double r) { return r < edge ? d : 2 / pi * d * std::asin(edge / r); });
    const AbelMatrices matrices = abel_matrices(bed);
    return (matrices.area * ((matrices.displacement * u).array() - exact).abs()).sum() / (pi * d);
  };
  EXPECT_LT(error(40), 0.01);
  EXPECT_GT(order(error), 1.2) << error(40) << " " << error(160);
}

// What keeps repeated transforms stable.
TEST(AbelMatrices, DisplacementIsAMeanOfTheSprings) {
  for (const SpringBed& bed : {bed_to(1, 60), uneven_bed()}) {
    const AbelMatrices matrices = abel_matrices(bed);
    const Eigen::VectorXd uniform = Eigen::VectorXd::Ones(bed.width.size());
    EXPECT_LT((matrices.displacement * uniform - uniform).cwiseAbs().maxCoeff(), 1e-13);  // roundoff of 60 sums
    EXPECT_LT((matrices.image * uniform - uniform).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_GE(matrices.displacement.minCoeff(), 0);
    EXPECT_TRUE(matrices.image.isLowerTriangular(0));
    EXPECT_TRUE(matrices.stress.isUpperTriangular(0));
  }
}

TEST(AbelMatrices, WorksAndLoadsOfSurfaceAndSpringsAreEqual) {
  for (const SpringBed& bed : {bed_to(1, 60), uneven_bed()}) {
    const AbelMatrices matrices = abel_matrices(bed);
    const Eigen::ArrayXd q = (3 * bed.position).cos(), u = 1 + (7 * bed.position).sin();
    const Eigen::ArrayXd stress = (matrices.stress * q.matrix()).array();
    const Eigen::ArrayXd surface = (matrices.displacement * u.matrix()).array();
    // Roundoff.
    EXPECT_NEAR((matrices.area * stress * surface).sum(), 2 * (bed.width * q * u).sum(), 1e-13);
    EXPECT_NEAR((matrices.area * stress).sum(), 2 * (bed.width * q).sum(), 1e-13);
  }
}

TEST(AbelMatrices, IntervalsWithGapsAreRejected) {
  SpringBed bed = bed_to(1, 10);
  bed.position += 0.01;
  EXPECT_THROW(abel_matrices(bed), std::invalid_argument);
  bed = bed_to(1, 10);
  bed.width[4] *= 0.5;
  EXPECT_THROW(abel_matrices(bed), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::abel_matrices_test
