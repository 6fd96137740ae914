#pragma once

#include <optional>

#include "mdr/layer/layer_contact.h"

namespace fretval::mdr {

/// Partial slip of a layer's contact, tangentially by the row of springs that has G* and its own kernel K_T:
///
///   G* w_x(x) = q_x(x) + (1/pi) int_-a^a K_T(x-y) q_x(y) dy
///   w_x = u_x for x < c,   q_x = mu q for c < x < a,   q_x continuous at c
///
/// The conditions on w_x and q_x are those of the three-dimensional contact, r < c and c < r < a, as its transforms are
/// triangular. With q_x = mu (q - s), s held within c, the stick zone is an ordinary contact of radius c under the load
/// of sliding:
///
///   s + (1/pi) int_-c^c K_T s dy = q + (1/pi) int_-a^a K_T q dy - D on x < c,   s(c) = 0,   u_x = mu E*/G* D
///
/// Over a half-space D = d - g(c), and s is the load of the smaller contact (Cattaneo, Mindlin, Jaeger, Ciavarella).
/// Over a layer s is not the load of a smaller contact, as K_T is not K.

/// The row of springs of a stick zone of radius c, made once for many normal loads.
class StickRow {
 public:
  /// outer: no contact that is asked for is larger, m.
  StickRow(const Profile& profile, const Layer& layer, double stick_radius, double outer,
           const RowFineness& fineness = {});

  [[nodiscard]] double stick_radius() const { return stick_radius_; }
  /// The load s that is held back from sliding, with its integral and the displacement D that belongs to it.
  struct Held {
    double depth;  ///< D in m
    double load;   ///< int_0^c s/E* dx, in m^2
    Eigen::ArrayXd at_points;
  };
  [[nodiscard]] Held held(const LayerContact& contact) const;
  [[nodiscard]] const LayerRow& row() const { return row_; }

 private:
  double stick_radius_;
  LayerRow row_;
  Eigen::ArrayXd unit_;  // load under a uniform displacement
  double unit_edge_;
};

/// How far and how hard an indenter in normal contact has to be pushed tangentially until it sticks within c alone.
/// Both are linear in the normal load q, so that the reaches of several loads add up.
struct SlipReach {
  double depth;  ///< D in m: u_x = mu E*/G* D, d - g(c) over a half-space
  double load;   ///< in m^2: F_x = 2 mu E* load
};
SlipReach slip_reach(const StickRow& row, const LayerContact& contact);

/// State after a tangential displacement that has grown under a constant normal load, on an elastic layer or a relaxed
/// one.
struct LayerPush {
  double stick_radius;             ///< c in m
  double tangential_displacement;  ///< u_x in m
  double tangential_force;         ///< F_x in N
};

/// mu positive, shear modulus in Pa, 0 < c <= a.
LayerPush layer_push_to_radius(const LayerContact& contact, double mu, double shear_modulus, double stick_radius);

/// The state after a push by a tangential displacement in m, or by a tangential force in N, not negative. Empty: all of
/// the contact slides.
std::optional<LayerPush> layer_push(const LayerContact& contact, double mu, double shear_modulus,
                                    double tangential_displacement);
std::optional<LayerPush> layer_push_under_force(const LayerContact& contact, double mu, double shear_modulus,
                                                double tangential_force);

}  // namespace fretval::mdr
