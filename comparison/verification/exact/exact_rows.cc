#include "comparison/verification/exact/exact_rows.h"

#include <cmath>

namespace fretval {
namespace {

using Rows = std::vector<ConvergenceRow>;

void add(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

void add_indentation(Rows& rows, const std::vector<ConvergenceMesh>& meshes) {
  add(rows, indentation_rows(meshes, exact_indentation("Hertz", "Hertz 1882, Johnson 1985", 2),
                             {1e-6, 3, far_field, 1e-6, far_field_note}, {1e-6, 3, bulk_floor, 1e-5, bulk_note}));
  add(rows, indentation_rows(meshes, exact_indentation("cone", "Love 1939, Sneddon 1965", 1),
                             {1e-6, 3, far_field, 1e-6, far_field_note},
                             {1e-5, 2, far_field, 1e-5, "the ring at the tip: h^2"}));
  add(rows, indentation_rows(meshes, exact_indentation("power law n = 4", "Galin 1946, Sneddon 1965", 4),
                             {1e-6, 3, far_field, 1e-6, far_field_note}, {6e-6, 2, far_field, 1e-5, far_field_note}));
  add(rows, punch_rows(meshes, exact_punch()));
}

void add_sliding(Rows& rows, const std::vector<ConvergenceMesh>& meshes) {
  add(rows, sliding_rows(meshes, exact_sliding()));
  add(rows, {cycle_row(meshes, exact_sliding()), unloading_row(meshes, exact_sliding())});
  add(rows, oblique_rows(meshes, exact_oblique(oblique_loading)));
  add(rows, {worn_edge_row(meshes, mdr::parabola(1))});
}

void add_time(Rows& rows, const std::vector<ConvergenceMesh>& meshes) {
  for (const auto row_of : {step_row, hertz_step_row, growing_contact_time_row, growing_contact_mesh_row,
                            retraction_time_row, retraction_mesh_row})
    rows.push_back(row_of(meshes, viscoelastic_body()));
}

/// All phases, each with three amplitudes: other positions of the edges within their ring.
std::vector<TangentialOscillation> all_phases(double amplitude) {
  std::vector<TangentialOscillation> oscillations;
  for (const double share : {0.86, 0.93, 1.0})
    for (int k = 0; k < 12; ++k) oscillations.push_back({share * amplitude, 15.0 * k});
  return oscillations;
}

/// At a phase of 90 degrees, where both stick radii are the same: for c/a from 0.1 to 0.13.
std::vector<TangentialOscillation> towards_no_stick(double modulus_ratio, double normal_amplitude) {
  std::vector<TangentialOscillation> oscillations;
  for (const double c : {0.1, 0.11, 0.12, 0.13}) {
    const double relief = (1 - normal_amplitude - c * c) / modulus_ratio;
    oscillations.push_back(
        {1.5 * friction_coefficient * std::sqrt(relief * relief - normal_amplitude * normal_amplitude), 90});
  }
  return oscillations;
}

void add_periodic(Rows& rows, const std::vector<ConvergenceMesh>& meshes) {
  const auto elastic = mdr::elastic(1);
  const auto solid = mdr::standard_solid(1, std::sqrt(3.5) - 1, 1);  // |G(omega = 1)| = 1.5
  const std::string source = "two tangents, Barber, Davies & Hills 2011";
  const char* floor = "floor: far field, 120 steps a cycle";
  const ConvergenceDemand demand{1e-6, 3, 2 * far_field, 5e-5, floor};
  const ConvergenceDemand small{2e-6, 3, far_field, 1e-3, floor};
  const ConvergenceDemand together{
      8e-6, 0.5, far_field, 5e-5, "the stick zone ends where the smallest contact does: hardly falls from 32 rings on"};
  // Elsewhere the normal amplitudes let the stick zone end some rings inside the smallest contact.
  for (const PeriodicCase& solution :
       {PeriodicCase{"periodic, elastic", source, elastic, 0.2, all_phases(0.27), demand, demand},
        PeriodicCase{"periodic, standard solid", source, solid, 0.1, all_phases(0.25), demand, demand},
        PeriodicCase{"periodic, c/a = 0.1 to 0.13", source, solid, 0.2, towards_no_stick(1.5, 0.2), small, small},
        PeriodicCase{"periodic, k = 1 in phase", source, solid, 0.2, {{0.12, 0}}, demand, together}})
    add(rows, periodic_rows(meshes, solution, exact_stick_radii()));
}

void add_bulk(Rows& rows) {
  const auto meshes = bulk_meshes(4);
  for (const BulkCase& solution : {BulkCase{"Kelvin's force along z", fem::Harmonic::normal, 2.5e-8, 4e-6},
                                   BulkCase{"Kelvin's force along x", fem::Harmonic::tangential, 2e-8, 4e-6}})
    add(rows, bulk_rows(meshes, solution, fem::point_force(solution.harmonic, 1)));
}

}  // namespace

std::vector<ConvergenceRow> exact_rows() {
  const auto meshes = half_space_meshes({16, 32, 64, 128});
  Rows rows;
  add_indentation(rows, meshes);
  add_sliding(rows, meshes);
  add_time(rows, meshes);
  add_periodic(rows, meshes);
  add_bulk(rows);
  return rows;
}

}  // namespace fretval
