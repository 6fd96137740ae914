#include <algorithm>
#include <cmath>

#include "comparison/verification/exact/exact_space_rows.h"
#include "fem/condensation/contact_events.h"
#include "fem/stick_zone/stick_radius.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

/// Indentations of both parts of the loading, with those among them at which a ring touches.
std::vector<double> indentations(const ObliqueLoading& loading, const Eigen::VectorXd& touch) {
  std::vector<double> all;
  for (int k = 0; k < n_positions; ++k) {
    all.push_back(position(k, loading.first, loading.second));
    all.push_back(position(k, loading.second, loading.last));
  }
  for (const double d : touch)
    if (loading.first < d && d < loading.last) all.push_back(d);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

double tangential_displacement(const ObliqueLoading& loading, double d) {
  const double sticking = std::clamp(d, loading.first, loading.second) - loading.first;
  return loading.sticking_slope * sticking + loading.slipping_slope * std::max(0.0, d - loading.second);
}

ExactOblique exact_oblique(const ObliqueLoading& loading) {
  const auto profile = mdr::parabola(1);
  const double mu = friction_coefficient, share = 2.0 / 3 * loading.sticking_slope;
  const auto stick_depth = [=](double d) {
    if (d <= loading.second) return d;
    // Inside the first contact a point sticks since u = 0, outside it since the contact came to it.
    const double u = tangential_displacement(loading, d), inside = d - u / (1.5 * mu);
    if (inside <= loading.first) return inside;
    return (mu * d - 2.0 / 3 * u - share * loading.first) / (mu - share);
  };
  const auto normal_force = [=](double d) { return mdr::normal_force(profile, 1, d); };
  return {[=](double d) { return mdr::contact_radius(profile, stick_depth(d)); },
          [=](double d) {
            const double stuck = stick_depth(d);
            return mu * (normal_force(d) - normal_force(stuck)) +
                   share * (normal_force(std::max(stuck, loading.first)) - normal_force(loading.first));
          }};
}

std::vector<ConvergenceRow> oblique_rows(const std::vector<ConvergenceMesh>& meshes, const ObliqueLoading& loading,
                                         const ExactOblique& exact) {
  const auto profile = mdr::parabola(1);
  // Steps end where a ring touches, so that the contact does not change within one: no error of time.
  const auto follow = [&](const ConvergenceMesh& mesh, const auto& take) {
    const auto means = means_of(profile, mesh.normal);
    const auto touch = fem::contact_events(mesh.normal.compliance, means).indentation;
    ElasticSliding sliding(mesh);
    for (const double d : indentations(loading, touch)) {
      sliding.step(tangential_displacement(loading, d), friction_limit(mesh, profile, d));
      take(sliding, d);
    }
  };
  const auto force_error = [&](const ConvergenceMesh& mesh) {
    double worst = 0;
    follow(mesh, [&](const ElasticSliding& sliding, double d) {
      take_worst(worst, (sliding.force() - exact.force(d)) / exact.force(loading.last));
    });
    return worst;
  };
  const auto radius_error = [&](const ConvergenceMesh& mesh) {
    const double first_contact = mdr::contact_radius(profile, loading.first);
    double worst = 0;
    int n_measured = 0;
    follow(mesh, [&](const ElasticSliding& sliding, double d) {
      const double radius = exact.stick_radius(d);
      if (d <= loading.second || radius > first_contact) return;
      take_worst(worst, (sliding.stick_radius() - radius) / mdr::contact_radius(profile, d));
      ++n_measured;
    });
    return n_measured > 0 ? worst : std::nan("");
  };
  const std::string solution = "oblique loading", source = "Jaeger 1993";
  return {mesh_row(solution, "force", source, meshes, {3e-6, 2, far_field, 1e-5, far_field_note}, force_error),
          mesh_row(solution, "stick radius", source, meshes,
                   {1e-6, 3, far_field, 5e-6,
                    "inside the first contact: less than six rings outside it the fit of the stick edge meets the "
                    "kink of the traction there, and is off by up to a ring"},
                   radius_error)};
}

}  // namespace fretval
