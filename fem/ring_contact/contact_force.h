#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "fem/condensation/compliance.h"
#include "fem/ring_contact/free_surface.h"
#include "fem/ring_contact/growing_edge.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// What an instant of a contact is read from; all must outlive this.
struct ContactInstant {
  const Eigen::VectorXd& pressure;
  const Eigen::VectorXd& depths;  ///< of PunchSeries; where rings touch within a step, of the instant (RingCourses)
  const Opening& opening;
  std::optional<TimesInContact> times = {};  ///< of a body with memory
};

/// What the depths bear beyond the contact around the centre, where rings press beyond the first free one. Around a
/// centre of too few rings to have an edge no force is told apart, only the uncertainty.
struct ForceBeyond {
  double force = 0, uncertainty = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(force, uncertainty);
  }
};

/// Normal force of the depths (see PunchSeries) of the contact around the centre, and where it ends.
struct ContactForce {
  double force, radius;
  double uncertainty = 0;  ///< of the force, by what it is next to the edge; see force_missed_at_edge
  ForceBeyond beyond = {};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(force, radius, uncertainty, beyond);
  }
};

/// How a force is read from the pressures of rings: by depths that go on to the edge of a contact which has grown from
/// its centre, or as their sum over the areas, which supposes nothing.
enum class ForceReading { up_to_the_edge, sum_of_rings };

/// The sum, and the outer edge of the outermost ring that is pressed. radii: of the rings, from 0 on.
ContactForce sum_of_rings(const std::vector<double>& radii, const Eigen::VectorXd& areas,
                          const Eigen::VectorXd& pressure);

/// Where all rings inside a flank are pressed, which touches all at once, the contact ends with the last of them: a
/// sum, up to the first free ring, as the singular pressure at its edge reaches the next one. What rings beyond bear
/// stands apart. Read from gaps, which have no edge there, the force was off by 1e-4 (48 rings).
ContactForce sum_inside_flank(const Compliance& compliance, const Eigen::VectorXd& pressure,
                              Eigen::Index n_inside_flank);

/// The edge is found from the gaps: with a dashpot, or a branch that relaxes while the edge crosses a ring, the
/// pressure jumps there, but for a retreat, where it vanishes.
ContactForce contact_force(const PunchSeries& series, const ContactInstant& instant);

/// The force on an elastic body. gap: of the free rings.
ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap);

}  // namespace fretval::fem
