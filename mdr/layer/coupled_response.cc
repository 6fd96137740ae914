#include "mdr/layer/coupled_response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/layer/coupled_history.h"
#include "mdr/layer/layer_contact.h"

namespace fretval::mdr {

namespace {

// Radius up to which there are springs, with room for a contact whose rim has memory, and for the springs beyond it
// which tell how steeply loads fall there.
double largest_radius(const Profile& profile, const Layer& layer, const PronyBody& body, const Prescribed& prescribed,
                      Eigen::Index fewest_springs) {
  const double springs_beyond = body.branch_moduli.empty() ? 0 : 3,
               room = 1 + std::max(0.05, springs_beyond / static_cast<double>(fewest_springs));
  const double most = maximum_indentation(prescribed.motion);
  const LayerContact contact = prescribed.normal_force
                                   ? layer_contact_under_force(profile, layer, body.relaxed_modulus, most)
                                   : layer_contact_at_depth(profile, layer, most);
  return std::min(room * contact.contact_radius, end_radius(profile));
}

}  // namespace

double edge_of_loads(const SpringBed& bed, const Eigen::ArrayXd& load) {
  Eigen::Index n = load.size();
  while (n > 0 && load[n - 1] <= 0) --n;
  if (n == 0) return 0;
  const double end = bed.position[n - 1] + bed.width[n - 1] / 2;
  if (n < 3) return end;
  const double q0 = load[n - 3], q1 = load[n - 2], q2 = load[n - 1], width = bed.width[0];
  if (!(q2 < q1 && q1 < q0)) return end;
  const double slope = width / (q2 - q1), bend = (slope - width / (q1 - q0)) / (q2 - q0);
  return bed.position[n - 1] - q2 * slope + q2 * q1 * bend;
}

SteppedForcedResponse coupled_response(const Profile& profile, const Layer& layer, const PronyBody& body, double mu,
                                       const Prescribed& prescribed, const SpringFineness& fineness) {
  const double outer = largest_radius(profile, layer, body, prescribed, fineness.n_springs / 2);
  const auto history = [&](Eigen::Index n, const Loading& loading, const HistoryControl& control) {
    HistoryControl watching = control;
    watching.watches_first_slip = true;
    SpringHistory course =
        coupled_history(coupled_bed(spring_bed(profile, outer, n), layer), body, mu, loading, watching);
    if (course.deepest.normal_load[n - 1] > 0)
      throw std::runtime_error("the contact reaches the end of the coupled springs");
    return course;
  };
  const auto radius = [&](const SpringHistory& course, double /*depth*/) {
    const Eigen::Index n = course.deepest.normal_load.size();
    return edge_of_loads(spring_bed(profile, outer, n), course.deepest.normal_load);
  };
  return extrapolated_response(
      history, radius, [&](double x) { return transform(profile, x); }, outer, body, mu, prescribed, fineness,
      Springs::coupled);
}

}  // namespace fretval::mdr
