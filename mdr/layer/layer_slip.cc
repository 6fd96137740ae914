#include "mdr/layer/layer_slip.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

// The stick radius c at which an excess that falls with c vanishes, between 0 and the contact radius.
double stick_radius_with(const std::function<double(double)>& excess, double contact_radius) {
  constexpr double least_share = 1e-9;
  const double lower = least_share * contact_radius;
  if (excess(lower) <= 0) return lower;
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, contact_radius,
                                                         boost::math::tools::eps_tolerance<double>(48), iterations);
  return (bracket.first + bracket.second) / 2;
}

StickRow row_of(const LayerContact& contact, double c) {
  return {contact.profile, contact.layer, c, contact.contact_radius};
}

// D of a contact all of which slides.
double sliding_depth(const LayerContact& contact) {
  const LayerKernel kernel = layer_kernel(contact.layer, Direction::tangential, 2 * contact.contact_radius);
  return spring_load(contact, 0) +
         coupling(kernel, amplitudes(kernel, contact.rule.point, contact.rule.weight * contact.at_points), 0);
}

}  // namespace

StickRow::StickRow(const Profile& profile, const Layer& layer, double stick_radius, double outer,
                   const RowFineness& fineness)
    : stick_radius_(stick_radius),
      row_(layer_row(profile, layer, Direction::tangential, stick_radius, outer, fineness)),
      unit_(row_.load(Eigen::ArrayXd::Ones(row_.points().size()))),
      unit_edge_(1 - coupling(row_.kernel(), row_.amplitudes_of(unit_), stick_radius)) {}

StickRow::Held StickRow::held(const LayerContact& contact) const {
  require_within("stick radius", stick_radius_, 0, contact.contact_radius);
  const LayerKernel& kernel = row_.kernel();
  const Eigen::ArrayXd sliding = amplitudes(kernel, contact.rule.point, contact.rule.weight * contact.at_points);
  const auto depth_at = [&](const Eigen::ArrayXd& x) -> Eigen::ArrayXd {
    return x.unaryExpr([&](double at) { return spring_depth(contact, at); }) -
           coupling(contact.kernel, contact.amplitudes, x) + coupling(kernel, sliding, x);
  };
  const Eigen::ArrayXd load = row_.load(depth_at(row_.points()));
  const Eigen::ArrayXd edge = Eigen::ArrayXd::Constant(1, stick_radius_);
  const double depth = (depth_at(edge)[0] - coupling(kernel, row_.amplitudes_of(load), stick_radius_)) / unit_edge_;
  const Eigen::ArrayXd held = load - depth * unit_;
  return {depth, row_.integral(held), held};
}

SlipReach slip_reach(const StickRow& row, const LayerContact& contact) {
  const StickRow::Held held = row.held(contact);
  return {held.depth, contact.load - held.load};
}

LayerPush layer_push_to_radius(const LayerContact& contact, double mu, double shear_modulus, double stick_radius) {
  require_positive("coefficient of friction", mu);
  require_positive("shear modulus", shear_modulus);
  require_positive("stick radius", stick_radius);
  const double nu = contact.layer.poisson_ratio;
  const SlipReach reach = slip_reach(row_of(contact, stick_radius), contact);
  return {stick_radius, mu * spring_modulus_ratio(nu) * reach.depth,
          2 * mu * spring_modulus(Direction::normal, nu) * shear_modulus * reach.load};
}

std::optional<LayerPush> layer_push(const LayerContact& contact, double mu, double shear_modulus,
                                    double tangential_displacement) {
  require_positive("coefficient of friction", mu);
  require_non_negative("tangential displacement", tangential_displacement);
  const double depth = tangential_displacement / (mu * spring_modulus_ratio(contact.layer.poisson_ratio));
  if (depth >= sliding_depth(contact)) return std::nullopt;
  const auto excess = [&](double c) { return slip_reach(row_of(contact, c), contact).depth - depth; };
  const double c = depth > 0 ? stick_radius_with(excess, contact.contact_radius) : contact.contact_radius;
  return layer_push_to_radius(contact, mu, shear_modulus, c);
}

std::optional<LayerPush> layer_push_under_force(const LayerContact& contact, double mu, double shear_modulus,
                                                double tangential_force) {
  require_positive("coefficient of friction", mu);
  require_non_negative("tangential force", tangential_force);
  const double most = mu * normal_force(contact, shear_modulus);
  if (tangential_force >= most) return std::nullopt;
  const double load = contact.load * tangential_force / most;
  const auto excess = [&](double c) { return slip_reach(row_of(contact, c), contact).load - load; };
  const double c = load > 0 ? stick_radius_with(excess, contact.contact_radius) : contact.contact_radius;
  return layer_push_to_radius(contact, mu, shear_modulus, c);
}

}  // namespace fretval::mdr
