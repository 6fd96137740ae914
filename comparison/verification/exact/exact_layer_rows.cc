#include <fmt/format.h>

#include <cmath>

#include "comparison/simulation/bodies/body.h"
#include "comparison/verification/exact/exact_rows.h"
#include "fem/history/friction_history.h"
#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/pressure_for_friction.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/layer/layer_slip.h"
#include "mdr/layer/layer_stick_radius.h"
#include "mdr/profiles/power_law.h"
#include "mdr/support/constants.h"
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
  // The far part of a layer that slides is stretched like a sheet, and its free edge has an effect of the second power
  // of its distance; in a bonded layer fields die out exponentially.
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
  constexpr int n_depths = 25;
  std::vector<double> indentations;
  for (int k = 0; k < n_depths; ++k)
    indentations.push_back(mdr::layer_contact(indenter(), layer, 0.8 + 0.2 * k / (n_depths - 1)).indentation);
  return static_errors(mesh, indenter(), indentations, [&](double indentation) {
    const auto known = mdr::layer_contact_at_depth(indenter(exact.steepness), layer, indentation);
    return RadiusAndForce{known.contact_radius, mdr::normal_force(known, exact.modulus)};
  });
}

/// Force of all rings inside r = 1 that move together, at their effective radius.
double error_of_punch(const fem::ContactProblem& problem, mdr::Direction direction, int n_rings,
                      const mdr::Layer& layer, const ExactScene& exact) {
  const double radius = problem.series.edges()[n_rings];
  const auto punch = mdr::layer_punch(layer, direction, radius);
  return problem.series.punch_force(n_rings) / mdr::punch_stiffness(punch, exact.modulus) - 1;
}

/// Stick radius of a push of the contact of radius 1 from rest, one box problem each, for stick radii from 0.3 to 0.9.
double error_of_push(const ConvergenceMesh& mesh, const mdr::Layer& layer, const ExactScene& exact) {
  const auto known = mdr::layer_contact(indenter(), layer, 1);
  const Eigen::VectorXd profile = means_of(indenter(), mesh.normal);
  const auto contact = fem::static_contact(mesh.normal, profile, known.indentation);
  const double force = fem::contact_force(fem::series_under(mesh.normal, profile), contact.pressure, contact.gap).force;
  const Eigen::VectorXd pressure =
      fem::pressure_for_friction(mesh.normal.series, mesh.tangential.series, contact.pressure, force);
  constexpr int n_radii = 25;
  double error = 0;
  for (int k = 0; k < n_radii; ++k) {
    const double radius = 0.3 + 0.6 * k / (n_radii - 1);
    const auto push = mdr::layer_push_to_radius(mdr::layer_contact(indenter(exact.steepness), layer, 1),
                                                exact.friction_coefficient, exact.modulus, radius);
    take_worst(error, stick_radius_of_push(mesh, pressure, push.tangential_displacement) - radius);
  }
  return error;
}

/// A tangential oscillation: its amplitude over the largest indentation, and its phase.
struct Shaking {
  double share, phase;
};
using Shakings = std::vector<Shaking>;

/// Errors of the stick radii of first slip and of shakedown of an elastic layer under oscillations, at a largest
/// contact radius of 1.
std::vector<double> errors_of_oscillation(const ConvergenceMesh& mesh, const mdr::Layer& layer,
                                          const Shakings& shakings, const ExactScene& exact) {
  const fem::HistoryControl control{120, 100, 1e-7};
  const double deepest = mdr::layer_contact(indenter(), layer, 1).indentation, normal_share = 0.15;
  fem::Motion motion = fem::one_frequency((1 - normal_share) * deepest, normal_share * deepest, 0, 0.0);
  motion.n_ramp_cycles = 10;
  const auto model = fem_model(mdr::elastic(1));
  const auto profile = means_of(indenter(), mesh.normal);
  double first_slip = 0, shakedown = 0;
  for (const auto& [share, phase] : shakings) {
    const double amplitude = share * deepest;
    motion.tangential = {{amplitude, 1, phase}};
    const auto [normal, friction] =
        fem::contact_history({mesh.normal, model, profile, motion, control.steps_per_cycle},
                             {mesh.tangential, model, friction_coefficient, motion, control.steps_per_cycle}, control);
    const auto zones = fem::stick_zones(mesh.tangential.compliance, friction, fem::stuck_rings(friction, motion));
    const double frequency = 1;
    const auto known = mdr::layer_stick_radii(
        indenter(exact.steepness), layer, 1, exact.friction_coefficient,
        {{motion.indentation, {{normal_share * deepest, frequency, 0}}, {{amplitude, frequency, phase}}},
         false,
         false});
    take_worst(first_slip, zones.first_slip.radius - known.first_slip.value_or(std::nan("")));
    take_worst(shakedown, zones.shakedown.radius - known.shakedown.value_or(std::nan("")));
  }
  return {first_slip, shakedown};
}

/// Tolerances at 64 rings, of the normal contact, of friction, and of friction that slips within two rings of the edge
/// of the smallest contact.
struct Tolerances {
  double normal, friction, narrow_slip;
};

Rows rows_of(const mdr::Layer& layer, const Tolerances& tolerances, const std::vector<int>& n_rings,
             const ExactScene& exact) {
  const auto name = name_of(layer);
  const char* source = "MDR's coupled springs";
  const bool bonded = layer.base == mdr::LayerBase::bonded;
  // 16 rings on a/H = 10 are wider than half of the layer, and part of what they err by cancels.
  constexpr double thin = 0.2;
  const double left_out = layer.thickness < thin ? 0.5 : 0, floor = bonded ? 1.5e-6 : 4e-6;
  const char* note = bonded ? "floor: where edges of rings lie, of first order"
                            : "floor: the free side, of the second order of its distance";
  const ConvergenceDemand normal{tolerances.normal, 3 - left_out, floor, note},
      // Of third order, which shows late where the floor is near.
      push{tolerances.friction, 2.5 - left_out, floor, note}, slip{tolerances.friction, 2 - left_out, floor, note},
      narrow_slip{tolerances.narrow_slip, 2 - left_out, floor, note};
  Rows rows{
      {name, "contact radius", source, normal}, {name, "force", source, normal}, {name, "flat punch", source, normal}};
  if (bonded) {
    rows.push_back({name, "tangential punch", source, normal});
    rows.push_back({name, "stick radius of a push", source, push});
    rows.push_back({name, "first-slip radius", source, slip});
    rows.push_back({name, "shakedown radius", source, slip});
    rows.push_back({name, "first-slip radius, little slip", source, narrow_slip});
    rows.push_back({name, "shakedown radius, little slip", source, narrow_slip});
  }
  const Shakings usual{{0.4, 0.5}, {0.44, 1.3}}, little{{0.14, 0.5}, {0.16, 0.5}, {0.15, 1.3}};
  return mesh_rows(rows, layer_meshes(layer, n_rings), [&](const ConvergenceMesh& mesh) {
    auto errors = errors_of_parabola(mesh, layer, exact);
    errors.push_back(error_of_punch(mesh.normal, mdr::Direction::normal, mesh.n_rings, layer, exact));
    if (!bonded) return errors;
    errors.push_back(error_of_punch(mesh.tangential, mdr::Direction::tangential, mesh.n_rings, layer, exact));
    errors.push_back(error_of_push(mesh, layer, exact));
    for (const auto& shakings : {usual, little})
      for (const double error : errors_of_oscillation(mesh, layer, shakings, exact)) errors.push_back(error);
    return errors;
  });
}

/// Forces of flat punches on ever thinner bonded layers, c (a + edge)^n, against c of an infinitely thin one: the ratio
/// of differences between discs of half and of the whole radius, in which the edge cancels, so that (H/a)² is left.
/// What squeezes an incompressible layer flows out between two plates (lubrication), and any other layer is a bed of
/// springs (Winkler).
Rows thin_layer_rows(const std::vector<int>& n_rings, const ExactScene& exact) {
  constexpr double rings_of_thickness = 4, compressible = 0.3, pi = mdr::pi;
  constexpr double modulus_over_shear = 2 * (1 - compressible) / (1 - 2 * compressible);
  const char* note = "16 rings are a/H = 4: terms beyond (H/a)² are not small yet";
  const auto demand = [note](double tolerance) { return ConvergenceDemand{tolerance, 2, 1e-6, note}; };
  Rows rows{{"thin layer, ν = 0.5, 4 rings to H", "flat punch", "lubrication: 3π G d a⁴/(8 H³)", demand(1e-2)},
            {"thin layer, ν = 0.5, 4 rings to H", "tangential punch", "Winkler: π G u a²/H", demand(1e-3)},
            {"thin layer, ν = 0.3, 4 rings to H", "flat punch", "Winkler: π M d a²/H", demand(2e-4)},
            {"thin layer, ν = 0.3, 4 rings to H", "tangential punch", "Winkler: π G u a²/H", demand(1e-3)}};
  for (auto& row : rows) row.resolutions = n_rings;
  for (const int n : n_rings) {
    const double thickness = rings_of_thickness / n;
    const auto error = [&](const fem::ContactProblem& problem, double power, double coefficient) {
      const auto root = [&](int discs) { return std::pow(problem.series.punch_force(discs), 1 / power); };
      const auto& edges = problem.series.edges();
      const double slope = (root(n) - root(n / 2)) / (edges[n] - edges[n / 2]);
      return std::pow(slope, power) / (coefficient * exact.modulus) - 1;
    };
    const auto incompressible = layer_meshes({thickness, 0.5}, {n}),
               other = layer_meshes({thickness, compressible}, {n});
    const double of_shear = pi / thickness;
    rows[0].errors.push_back(error(incompressible[0].normal, 4, 3 * pi / (8 * std::pow(thickness, 3))));
    rows[1].errors.push_back(error(incompressible[0].tangential, 2, of_shear));
    rows[2].errors.push_back(error(other[0].normal, 2, modulus_over_shear * of_shear));
    rows[3].errors.push_back(error(other[0].tangential, 2, of_shear));
  }
  return rows;
}

}  // namespace

Rows layer_rows(const std::vector<int>& n_rings, const ExactScene& exact) {
  Rows rows;
  using Tolerated = std::pair<mdr::Layer, Tolerances>;
  for (const auto& [layer, tolerances] :
       {Tolerated{{10, 0.5}, {1e-6, 4e-6, 4e-6}}, Tolerated{{2, 0.45}, {2e-6, 4e-6, 6e-6}},
        Tolerated{{1, 0.3}, {2e-6, 3e-6, 3e-6}}, Tolerated{{1, 0.5}, {4e-6, 5e-6, 2e-5}},
        Tolerated{{0.25, 0.5}, {1e-5, 1e-5, 3e-5}}, Tolerated{{0.1, 0.5}, {1e-4, 2e-4, 2e-4}},
        Tolerated{{0.1, 0.3}, {2e-5, 1.5e-5, 1.5e-5}}, Tolerated{{1, 0.5, mdr::LayerBase::frictionless}, {4e-6, 0, 0}}})
    append(rows, rows_of(layer, tolerances, n_rings, exact));
  append(rows, thin_layer_rows(n_rings, exact));
  return rows;
}

}  // namespace fretval
