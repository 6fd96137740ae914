#include "fem/full_contact/angular_grid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>
#include <tuple>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

using Complex = std::complex<double>;

constexpr double roundoff = 1e-13;

/// The image of a kept angle in a mirror, with the sign of t_y; t_x and p are unchanged.
struct Image {
  double angle, sign_of_y;
};

std::vector<Image> images_of(double angle, Mirrors mirrors) {
  std::vector<Image> images{{angle, 1}};
  if (mirrors != Mirrors::none) images.push_back({-angle, -1});
  if (mirrors == Mirrors::x_and_y) {
    images.push_back({pi - angle, -1});
    images.push_back({pi + angle, 1});
  }
  return images;
}

/// Contribution of a unit value at an angle to the harmonic e^{i l theta}.
Complex share_of_harmonic(unsigned n_around, int l, double angle) {
  const Complex i(0, 1);
  const double n = n_around;
  if (2 * static_cast<unsigned>(std::abs(l)) < n_around) return std::exp(-i * (l * angle)) / n;
  const double first = pi / n, highest = std::abs(l);
  return std::cos(highest * (angle - first)) / (2 * n) * std::exp(-i * (l * first));
}

/// Sum of the contributions of all images of an angle. of_x, of_y: contributions per t_x and t_y.
template <class Share>
Amplitude tangential_amplitude(const AngularGrid& grid, const FourierOrder& order, unsigned component,
                               const Share& share) {
  const Eigen::Index n = grid.n_kept();
  Amplitude amplitude{order, component, Eigen::VectorXd::Zero(2 * n)};
  for (Eigen::Index j = 0; j < n; ++j)
    for (const auto& image : images_of(grid.angles[j], grid.mirrors)) {
      const auto [of_x, of_y] = share(image.angle);
      amplitude.weights[j] += of_x;
      amplitude.weights[n + j] += image.sign_of_y * of_y;
    }
  return amplitude;
}

/// Real or imaginary part of the harmonic l of t_x + i t_y.
Amplitude part_of_harmonic(const AngularGrid& grid, int l, bool imaginary, double sign, const FourierOrder& order,
                           unsigned component) {
  return tangential_amplitude(grid, order, component, [&](double angle) {
    const Complex share = share_of_harmonic(grid.n_around, l, angle);
    return imaginary ? std::make_tuple(sign * share.imag(), sign * share.real())
                     : std::make_tuple(sign * share.real(), -sign * share.imag());
  });
}

void add_tangential(const AngularGrid& grid, std::vector<Amplitude>& amplitudes) {
  const int highest = static_cast<int>(grid.n_around) / 2;
  for (int l = -highest; l <= highest; ++l) {
    const bool is_s = l <= 0;
    const auto n = static_cast<unsigned>(is_s ? 1 - l : l - 1);
    const unsigned component = is_s || n == 0 ? 0 : 1;
    amplitudes.push_back(part_of_harmonic(grid, l, false, 1, {n, Parity::even}, component));
    amplitudes.push_back(part_of_harmonic(grid, l, true, is_s ? 1 : -1, {n, Parity::odd}, component));
  }
}

void add_normal(const AngularGrid& grid, std::vector<Amplitude>& amplitudes) {
  const Eigen::Index n_kept = grid.n_kept();
  for (unsigned n = 0; n <= grid.n_around / 2; ++n)
    for (const auto parity : {Parity::even, Parity::odd}) {
      const FourierOrder order{n, parity};
      if (order.is_torsion()) continue;
      Amplitude amplitude{order, vertical_component(order), Eigen::VectorXd::Zero(n_kept)};
      for (Eigen::Index j = 0; j < n_kept; ++j)
        for (const auto& image : images_of(grid.angles[j], grid.mirrors)) {
          const Complex share = share_of_harmonic(grid.n_around, static_cast<int>(n), image.angle);
          const double part = parity == Parity::even ? share.real() : -share.imag();
          amplitude.weights[j] -= (n == 0 ? 1 : 2) * part;
        }
      amplitudes.push_back(std::move(amplitude));
    }
}

/// Whether a field of an order is its own mirror image about the y axis.
bool is_symmetric_about_y(const FourierOrder& order, SurfaceField field) {
  const bool is_even = order.parity == Parity::even, order_is_even = order.n % 2 == 0;
  return field == SurfaceField::tangential ? is_even != order_is_even : is_even == order_is_even;
}

}  // namespace

AngularGrid angular_grid(unsigned n_around, Mirrors mirrors) {
  const unsigned n_images = mirrors == Mirrors::none ? 1 : mirrors == Mirrors::x ? 2 : 4;
  if (n_around == 0 || n_around % n_images != 0)
    throw std::invalid_argument("the number of angles around the axis is " + std::to_string(n_around) +
                                ", must be a positive multiple of " + std::to_string(n_images));
  const Eigen::Index n_kept = n_around / n_images;
  AngularGrid grid{n_around, mirrors, Eigen::VectorXd(n_kept)};
  for (Eigen::Index j = 0; j < n_kept; ++j) grid.angles[j] = (static_cast<double>(j) + 0.5) * 2 * pi / n_around;
  return grid;
}

std::vector<MirroredAngle> whole_circle(const AngularGrid& grid) {
  const auto n = static_cast<Eigen::Index>(grid.n_around);
  std::vector<MirroredAngle> circle;
  for (Eigen::Index j = 0; j < n; ++j) {
    MirroredAngle point{(static_cast<double>(j) + 0.5) * 2 * pi / static_cast<double>(n), j, 1};
    const auto reflect = [&](Eigen::Index image) {
      if (image >= point.kept) return;
      point.kept = image;
      point.sign_of_y *= -1;
    };
    if (grid.mirrors != Mirrors::none) reflect(n - 1 - point.kept);
    if (grid.mirrors == Mirrors::x_and_y) reflect(n / 2 - 1 - point.kept);
    circle.push_back(point);
  }
  return circle;
}

std::vector<Amplitude> amplitudes_of(const AngularGrid& grid, SurfaceField field) {
  std::vector<Amplitude> amplitudes;
  if (field == SurfaceField::tangential)
    add_tangential(grid, amplitudes);
  else
    add_normal(grid, amplitudes);
  const auto vanishes = [&](const Amplitude& a) { return a.weights.norm() * grid.n_around < roundoff; };
  amplitudes.erase(std::remove_if(amplitudes.begin(), amplitudes.end(), vanishes), amplitudes.end());
  const auto place = [&](const Amplitude& a) {
    return std::make_tuple(a.order.parity, !is_symmetric_about_y(a.order, field), a.order.n, a.component);
  };
  std::sort(amplitudes.begin(), amplitudes.end(),
            [&](const Amplitude& a, const Amplitude& b) { return place(a) < place(b); });
  return amplitudes;
}

}  // namespace fretval::fem
