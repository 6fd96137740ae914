#include "comparison/verification/exact/exact_parts.h"

#include <cmath>

#include "comparison/simulation/bodies/body.h"
#include "meshes/grading.h"

namespace fretval {

Meshes half_space_meshes(const std::vector<int>& n_rings) {
  Meshes meshes;
  for (const int n : n_rings) {
    Body body = make_body({meshes::uniform_nodes(1.125, static_cast<unsigned>(n) * 9 / 8), 0.15, 25, 3});
    meshes.push_back({n, std::move(body.normal.contact), std::move(body.tangential->contact)});
  }
  return meshes;
}

double position(int k, double first, double last) {
  return first + (last - first) * k / (n_positions - 1);
}

void take_worst(double& worst, double error) {
  if (!(std::abs(error) <= worst)) worst = std::isnan(worst) ? worst : std::abs(error);
}

fem::RelaxationModel fem_model(const mdr::PronyBody& body) {
  return {body.relaxed_modulus, body.branch_moduli, body.branch_times, body.viscosity};
}

void append(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

ConvergenceRow mesh_row(const ConvergenceRow& row, const Meshes& meshes,
                        const std::function<double(const ConvergenceMesh&)>& error) {
  return mesh_rows(Rows{row}, meshes, [&](const ConvergenceMesh& mesh) { return std::vector<double>{error(mesh)}; })[0];
}

ConvergenceRow time_row(ConvergenceRow row, const std::vector<int>& n_steps, const std::function<double(int)>& error) {
  row.refined = "steps";
  row.resolutions = n_steps;
  for (const int n : n_steps) row.errors.push_back(error(n));
  return row;
}

}  // namespace fretval
