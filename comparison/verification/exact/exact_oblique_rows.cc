#include <algorithm>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
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

std::vector<ConvergenceRow> oblique_rows(const std::vector<ConvergenceMesh>& meshes, const ExactOblique& exact) {
  const auto& loading = oblique_loading;
  const auto profile = mdr::parabola(1);
  const double first_contact = mdr::contact_radius(profile, loading.first);
  const auto errors = [&](const ConvergenceMesh& mesh) {
    const auto touch = fem::contact_events(mesh.normal.compliance, means_of(profile, mesh.normal)).indentation;
    ElasticSliding sliding(mesh);
    double force_error = 0, radius_error = 0;
    int n_radii = 0;
    // Steps end where a ring touches, so that the contact does not change within one: no error of time.
    for (const double d : indentations(loading, touch)) {
      sliding.step(tangential_displacement(loading, d), friction_limit(mesh, profile, d));
      take_worst(force_error, (sliding.force() - exact.force(d)) / exact.force(loading.last));
      const double radius = exact.stick_radius(d);
      if (d <= loading.second || radius > first_contact) continue;
      take_worst(radius_error, (sliding.stick_radius() - radius) / mdr::contact_radius(profile, d));
      ++n_radii;
    }
    return std::vector<double>{force_error, n_radii > 0 ? radius_error : std::nan("")};
  };
  const std::string solution = "oblique loading", source = "Jaeger 1993";
  return mesh_rows(
      {{solution, "force", source, {3e-6, 2, far_field, 1e-5, far_field_note}},
       {solution,
        "stick radius",
        source,
        {1e-6, 3, far_field, 5e-6,
         "inside the first contact: less than six rings outside it the fit of the stick edge meets the kink of the "
         "traction there, and is off by up to a ring"}}},
      meshes, errors);
}

}  // namespace fretval
