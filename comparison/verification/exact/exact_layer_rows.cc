#include <fmt/format.h>

#include "comparison/simulation/bodies/body.h"
#include "comparison/verification/exact/exact_rows.h"
#include "fem/condensation/contact_events.h"
#include "fem/contact/contact_force.h"
#include "fem/stick_zone/contact_radius.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/profiles/power_law.h"
#include "meshes/grading.h"

namespace fretval {
namespace {

/// The contact radius is 1 at the largest indentation, on a line of 1.125.
mdr::Profile indenter(double steepness = 1) {
  return mdr::power_law(steepness / 2, 2);
}

std::string name_of(const mdr::Layer& layer) {
  return fmt::format("layer a/H = {:g}, ν = {:g}{}", 1 / layer.thickness, layer.poisson_ratio,
                     layer.base == mdr::LayerBase::bonded ? "" : ", sliding");
}

Meshes layer_meshes(const mdr::Layer& layer, const std::vector<int>& n_rings) {
  // Of a layer that slides the far part is stretched like a sheet, whose free edge lets through the second power of its
  // distance; of a bonded one fields die out exponentially.
  constexpr double length = 1.125, growth = 0.2;
  const double thicknesses_beyond = layer.base == mdr::LayerBase::bonded ? 12 : 600;
  Meshes meshes;
  for (const int n : n_rings) {
    BodyDescription description{meshes::uniform_nodes(length, static_cast<unsigned>(n) * 9 / 8), growth,
                                length + thicknesses_beyond * layer.thickness, 3};
    description.tangential = layer.base == mdr::LayerBase::bonded;
    description.poisson_ratio = layer.poisson_ratio;
    description.thickness = layer.thickness;
    description.slides_on_base = !description.tangential;
    Body body = make_body(description);
    meshes.push_back({n, body.normal.contact, body.tangential ? body.tangential->contact : body.normal.contact});
  }
  return meshes;
}

/// Contact radius and force of a parabola, for contact radii from 0.8 to 1.
std::vector<double> errors_of_parabola(const ConvergenceMesh& mesh, const mdr::Layer& layer, const ExactScene& exact) {
  const Eigen::VectorXd profile = means_of(indenter(), mesh.normal);
  const auto events = fem::contact_events(mesh.normal.compliance, profile);
  constexpr int n_depths = 25;
  double radius_error = 0, force_error = 0;
  for (int k = 0; k < n_depths; ++k) {
    const double indentation = mdr::layer_contact(indenter(), layer, 0.8 + 0.2 * k / (n_depths - 1)).indentation;
    const auto known = mdr::layer_contact_at_depth(indenter(exact.steepness), layer, indentation);
    const auto contact = fem::static_contact(mesh.normal, profile, indentation);
    const double force = fem::contact_force(mesh.normal.series, contact.pressure, contact.gap).force;
    take_worst(radius_error, fem::largest_contact_radius(contact.gap, events).radius / known.contact_radius - 1);
    take_worst(force_error, force / mdr::normal_force(known, exact.modulus) - 1);
  }
  return {radius_error, force_error};
}

/// Force of all rings inside r = 1 that move together, at their effective radius.
double error_of_punch(const fem::ContactProblem& problem, mdr::Direction direction, int n_rings,
                      const mdr::Layer& layer, const ExactScene& exact) {
  const double radius = problem.series.edges()[n_rings];
  const auto punch = mdr::layer_punch(layer, direction, radius);
  return problem.series.punch_force(n_rings) / mdr::punch_stiffness(punch, exact.modulus) - 1;
}

/// tolerance: at 64 rings. Uniform pressures on rings leave the second order of a smooth kernel, which grows with a/H.
Rows rows_of(const mdr::Layer& layer, double tolerance, const std::vector<int>& n_rings, const ExactScene& exact) {
  const auto name = name_of(layer);
  const char* source = "MDR's coupled springs";
  const bool bonded = layer.base == mdr::LayerBase::bonded;
  const ConvergenceDemand demand{tolerance, 2, 1.5e-5, "floor: where edges of rings lie, of first order"};
  Rows rows{
      {name, "contact radius", source, demand}, {name, "force", source, demand}, {name, "flat punch", source, demand}};
  if (bonded) rows.push_back({name, "tangential punch", source, demand});
  return mesh_rows(rows, layer_meshes(layer, n_rings), [&](const ConvergenceMesh& mesh) {
    auto errors = errors_of_parabola(mesh, layer, exact);
    errors.push_back(error_of_punch(mesh.normal, mdr::Direction::normal, mesh.n_rings, layer, exact));
    if (bonded)
      errors.push_back(error_of_punch(mesh.tangential, mdr::Direction::tangential, mesh.n_rings, layer, exact));
    return errors;
  });
}

}  // namespace

Rows layer_rows(const std::vector<int>& n_rings, const ExactScene& exact) {
  Rows rows;
  using Tolerated = std::pair<mdr::Layer, double>;
  for (const auto& [layer, tolerance] :
       {Tolerated{{10, 0.5}, 2e-5}, Tolerated{{2, 0.45}, 6e-5}, Tolerated{{1, 0.3}, 1e-4}, Tolerated{{1, 0.5}, 1.5e-4},
        Tolerated{{0.25, 0.5}, 4e-4}, Tolerated{{1, 0.5, mdr::LayerBase::frictionless}, 1.5e-4}})
    append(rows, rows_of(layer, tolerance, n_rings, exact));
  return rows;
}

}  // namespace fretval
