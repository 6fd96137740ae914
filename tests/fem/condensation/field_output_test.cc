#include "fem/condensation/field_output.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "fem/condensation/effective_radii.h"
#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"
#include "tests/fem/vtu_data.h"

namespace fretval::fem::field_output_test {
namespace {

struct Body {
  HarmonicSpace space;
  Condensation condensation;
  Compliance compliance;

  explicit Body(Harmonic harmonic)
      : space(quarter_disc_grid(1, 16, 20, 0.25), harmonic, 3),
        condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "body"),
        compliance(contact_compliance(space.contact_line(), condensation)) {}

  [[nodiscard]] Eigen::VectorXd extend(const Eigen::VectorXd& rings) const {
    return extend_into_body(space, condensation, compliance, rings);
  }
};

// Roundoff of the two factors, 1e-12 of the stiffest rings.
TEST(FieldOutput, ExtendsTheDisplacementsOfTheRings) {
  for (const Harmonic harmonic : {Harmonic::normal, Harmonic::tangential}) {
    const Body body(harmonic);
    const auto& line = body.space.contact_line();
    const Eigen::VectorXd rings = random_vector(16, 1), field = body.extend(rings);
    Eigen::VectorXd on_line(line.loads.rows());
    for (std::size_t i = 0; i < line.dofs.size(); ++i) on_line[static_cast<Eigen::Index>(i)] = field[line.dofs[i]];
    const Eigen::VectorXd means = (line.loads.transpose() * on_line).cwiseQuotient(line.areas);
    EXPECT_LT((means - rings).cwiseAbs().maxCoeff(), 1e-10);
  }
}

// Below a flat punch, on the axis at depth z, nu = 1/2: u_z = (2 d/pi) [atan(a/z) + a z/(a^2 + z^2)] (Sneddon 1946).
// Of 16 rings, second order: 1.1e-4 measured.
TEST(FieldOutput, SinksBelowAFlatPunchLikeTheHalfSpace) {
  const Body body(Harmonic::normal);
  const Eigen::VectorXd field = body.extend(Eigen::VectorXd::Ones(16));
  const auto& parts = body.space.parts();
  const double a = effective_radii(body.compliance).radius[16];
  std::vector<dealii::Point<2>> support(parts.dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(), parts.dofs, support);
  const auto vertical = dealii::DoFTools::extract_dofs(parts.dofs, [&] {
    dealii::ComponentMask mask(parts.element.n_components(), false);
    mask.set(vertical_component(Harmonic::normal), true);
    return mask;
  }());
  int n_checked = 0;
  for (const auto dof : vertical) {
    const double z = -support[dof][1];
    if (support[dof][0] > 1e-12 || z < 0.1 || z > 5) continue;
    EXPECT_NEAR(field[static_cast<Eigen::Index>(dof)], 2 / pi * (std::atan(a / z) + a * z / (a * a + z * z)), 3e-4)
        << z;
    ++n_checked;
  }
  EXPECT_GT(n_checked, 20);
}

/// Without its date.
std::string vtu_of(const HarmonicSpace& space, const Eigen::VectorXd& field, double length, double depth) {
  std::ostringstream stream;
  write_vtu(space, field, length, depth, stream);
  return stream.str().substr(stream.str().find("<VTKFile"));
}

/// A field of given components at each node.
Eigen::VectorXd field_of(const HarmonicSpace& space, const std::vector<double>& components) {
  const auto& parts = space.parts();
  Eigen::VectorXd field = Eigen::VectorXd::Zero(space.n_dofs());
  for (unsigned c = 0; c < components.size(); ++c) {
    dealii::ComponentMask mask(parts.element.n_components(), false);
    mask.set(c, true);
    for (const auto dof : dealii::DoFTools::extract_dofs(parts.dofs, mask))
      field[static_cast<Eigen::Index>(dof)] = components[c];
  }
  return field;
}

// Components U and W count inwards and down, the axes of the file outwards and up. Of the first harmonic they are s, m
// and W with u_r = (m + s) cos(theta) and u_theta = (m - s) sin(theta). A disc of 6 units of 3 m, depths of 2 m.
TEST(FieldOutput, HasEveryDisplacementUnderItsNameInMetres) {
  const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  const auto file_of = [&](Harmonic harmonic, const std::vector<double>& components) {
    const HarmonicSpace space(grid, harmonic, 2);
    return vtu_of(space, field_of(space, components), 3, 2);
  };
  const auto all_are = [](const std::string& file, const char* name, float value) {
    const auto values = vtu_data(file, name);
    EXPECT_GT(values.size(), 100U);
    for (const float one : values) EXPECT_FLOAT_EQ(one, value) << name;
  };
  const auto normal = file_of(Harmonic::normal, {0.5, 0.75});
  all_are(normal, "u_r", -1);
  all_are(normal, "u_z", -1.5);
  const auto tangential = file_of(Harmonic::tangential, {0.5, 2, 0.75});
  all_are(tangential, "u_r_cos", 5);
  all_are(tangential, "u_theta_sin", 3);
  all_are(tangential, "u_z_cos", 1.5);
  const auto points = vtu_data(normal, "");
  EXPECT_FLOAT_EQ(*std::max_element(points.begin(), points.end()), 18);
  EXPECT_FLOAT_EQ(*std::min_element(points.begin(), points.end()), -18);
}

TEST(FieldOutput, WritesDisplacementsInTheirUnit) {
  const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  for (const Harmonic harmonic : {Harmonic::normal, Harmonic::tangential}) {
    const HarmonicSpace space(grid, harmonic, 2);
    const Eigen::VectorXd field = random_vector(space.n_dofs(), 1);
    const std::string file = vtu_of(space, field, 3, 2);
    EXPECT_EQ(file, vtu_of(space, 2 * field, 3, 1));
    EXPECT_NE(file, vtu_of(space, field, 3, 1));
    EXPECT_NE(file, vtu_of(space, field, 1.5, 2));
    const bool normal = harmonic == Harmonic::normal;
    for (const char* name : {"\"u_r\"", "\"u_z\""}) EXPECT_EQ(file.find(name) != std::string::npos, normal);
    for (const char* name : {"\"u_r_cos\"", "\"u_theta_sin\"", "\"u_z_cos\""})
      EXPECT_EQ(file.find(name) != std::string::npos, !normal);
  }
}

}  // namespace
}  // namespace fretval::fem::field_output_test
