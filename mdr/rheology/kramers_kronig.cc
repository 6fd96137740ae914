#include "mdr/rheology/kramers_kronig.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/non_negative_least_squares.h"

namespace fretval::mdr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double quadrature_allowance = 0.1;
constexpr double n_standard_deviations = 5;  // for the largest of a hundred, with a size that is itself estimated

const double decade = std::log(10.0);

// Means of logarithms over parts of the table, and how many values each stands for.
struct Means {
  VectorXd log_frequency, storage, loss, n_values;
};

Means means_of(const ModulusTable& table) {
  const double first = std::log(table.frequency.front());
  std::vector<VectorXd> sums;
  double last_part = -1;
  for (std::size_t i = 0; i < table.frequency.size(); ++i) {
    const double log_frequency = std::log(table.frequency[i]);
    const double part = std::floor((log_frequency - first) / (decade / 4) + 1e-9);
    if (part > last_part) sums.push_back(VectorXd::Zero(4));
    last_part = part;
    sums.back() += Eigen::Vector4d(log_frequency, std::log(table.storage[i]), std::log(table.loss[i]), 1);
  }
  const Index n = static_cast<Index>(sums.size());
  Means means{VectorXd(n), VectorXd(n), VectorXd(n), VectorXd(n)};
  for (Index j = 0; j < n; ++j) {
    const VectorXd& sum = sums[static_cast<std::size_t>(j)];
    means.n_values(j) = sum(3);
    means.log_frequency(j) = sum(0) / sum(3);
    means.storage(j) = std::exp(sum(1) / sum(3));
    means.loss(j) = std::exp(sum(2) / sum(3));
  }
  return means;
}

// Standard deviation of the relative noise, from the misfit of each value to the cubic through its four neighbours.
// The median makes it blind to a few outliers or steps.
double noise(const std::vector<double>& frequency, const std::vector<double>& moduli) {
  std::vector<double> misfits;
  for (std::size_t j = 2; j + 2 < frequency.size(); ++j) {
    double misfit = std::log(moduli[j]), variance = 1;
    for (const std::size_t k : {j - 2, j - 1, j + 1, j + 2}) {
      double weight = 1;
      for (const std::size_t m : {j - 2, j - 1, j + 1, j + 2}) {
        if (m != k) weight *= std::log(frequency[j] / frequency[m]) / std::log(frequency[k] / frequency[m]);
      }
      misfit -= weight * std::log(moduli[k]);
      variance += weight * weight;
    }
    const double scaled = std::abs(misfit) / std::sqrt(variance);
    if (std::isfinite(scaled)) misfits.push_back(scaled);  // not where logarithms of neighbours coincide
  }
  const auto middle = misfits.begin() + static_cast<std::ptrdiff_t>(misfits.size() / 2);
  if (middle == misfits.end()) return 0;
  std::nth_element(misfits.begin(), middle, misfits.end());
  return *middle / 0.6745;  // median of the size of a standard normal variable
}

// int_y^inf ln coth(t/2) dt for y >= 0 to 1e-6, by its expansions for small and for large y.
double kernel_beyond(double y) {
  if (y == 0) return pi * pi / 4;
  const double y2 = y * y;
  if (y < 1) {
    const double series = y2 / 36 * (1 - y2 * (7. / 200 - y2 * (31. / 17640 - y2 / 9524)));
    return pi * pi / 4 - y * (std::log(2 / y) + 1 + series);
  }
  double integral = 0;
  for (int n = 1; n < 16; n += 2) integral += 2 * std::exp(-n * y) / (n * n);
  return integral;
}

// Loss at y = 0 by a unit rise of G' that is linear in log frequency from y = a to b. Differences of what lies beyond
// keep their accuracy far away.
double loss_by_rise(double a, double b) {
  const double nearer = a > 0 ? kernel_beyond(a) : kernel_beyond(std::max(-b, 0.0));
  const double farther = a > 0 ? kernel_beyond(b) : kernel_beyond(-a);
  const double other_side = a <= 0 && b > 0 ? pi * pi / 4 - kernel_beyond(b) : 0;
  return (nearer - farther + other_side) / (b - a) / pi;
}

// Row j holds the weights of the values of G' in the loss at mean j.
MatrixXd loss_from_storage(const VectorXd& y) {
  MatrixXd weights = MatrixXd::Zero(y.size(), y.size());
  for (Index j = 0; j < y.size(); ++j) {
    for (Index k = 0; k + 1 < y.size(); ++k) {
      const double loss = loss_by_rise(y(k) - y(j), y(k + 1) - y(j));
      weights(j, k) -= loss;
      weights(j, k + 1) += loss;
    }
  }
  return weights;
}

// Columns: loss by rises of G' beyond either end of the range; rises farther away do not differ in shape.
MatrixXd loss_from_outside(const VectorXd& y) {
  const double ends[] = {0, 0.25 * decade, 0.5 * decade, decade, 2 * decade, 4 * decade};
  MatrixXd loss(y.size(), 10);
  for (Index j = 0; j < y.size(); ++j) {
    const double to_slow = y(j) - y(0), to_fast = y(y.size() - 1) - y(j);
    for (Index k = 0; k < 5; ++k) {
      loss(j, 2 * k) = loss_by_rise(to_slow + ends[k], to_slow + ends[k + 1]);
      loss(j, 2 * k + 1) = loss_by_rise(to_fast + ends[k], to_fast + ends[k + 1]);
    }
  }
  return loss;
}

// Allowed relative deviations, see the header: noise of the storage modulus enters through the weights.
VectorXd allowance(const ModulusTable& table, const Means& means, const MatrixXd& weights) {
  const VectorXd variance = means.storage.cwiseAbs2().cwiseQuotient(means.n_values);
  const VectorXd by_storage =
      noise(table.frequency, table.storage) * (weights.cwiseAbs2() * variance).cwiseSqrt().cwiseQuotient(means.loss);
  const VectorXd by_loss = noise(table.frequency, table.loss) * means.n_values.cwiseSqrt().cwiseInverse();
  return quadrature_allowance + n_standard_deviations * (by_storage.array().square() + by_loss.array().square()).sqrt();
}

}  // namespace

std::string too_sparse_for_kramers_kronig(const ModulusTable& table) {
  validate(table);
  constexpr std::size_t fewest = 8;
  constexpr double decade_and_roundoff = 10 * (1 + 1e-9);
  const std::vector<double>& f = table.frequency;
  std::ostringstream reason;
  if (f.size() < fewest) {
    reason << f.size() << " frequencies, must be at least " << fewest;
  } else if (f.back() * (1 + 1e-9) < 10 * f.front()) {
    reason << "frequencies from " << f.front() << " to " << f.back() << " Hz, must be at least a decade";
  } else {
    for (std::size_t i = 1; i < f.size(); ++i)
      if (f[i] > f[i - 1] * decade_and_roundoff) {
        reason << "none between " << f[i - 1] << " and " << f[i] << " Hz, must be no more than a decade apart";
        break;
      }
  }
  return reason.str();
}

KramersKronig kramers_kronig(const ModulusTable& table) {
  if (const auto reason = too_sparse_for_kramers_kronig(table); !reason.empty())
    throw std::invalid_argument("too sparse for a Kramers-Kronig check: " + reason);
  const Means means = means_of(table);
  const MatrixXd weights = loss_from_storage(means.log_frequency);
  const VectorXd allowed = allowance(table, means, weights);

  const VectorXd inside = (weights * means.storage).cwiseQuotient(means.loss);
  const MatrixXd outside = means.loss.cwiseInverse().asDiagonal() * loss_from_outside(means.log_frequency);
  const VectorXd rises =
      non_negative_least_squares(allowed.cwiseInverse().asDiagonal() * outside, (1 - inside.array()) / allowed.array());
  const VectorXd deviation = (inside + outside * rises).array() - 1;

  const VectorXd excess = deviation.cwiseAbs().cwiseQuotient(allowed);
  Index worst;
  excess.maxCoeff(&worst);
  const VectorXd frequency = means.log_frequency.array().exp();
  const auto values = [](const VectorXd& v) { return std::vector<double>(v.data(), v.data() + v.size()); };
  return {values(frequency), values(deviation), values(allowed),
          deviation(worst),  frequency(worst),  excess.norm() / allowed.cwiseInverse().norm(),
          excess(worst) <= 1};
}

}  // namespace fretval::mdr
