#include "fem/condensation/body_field.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "fem/condensation/far_field.h"
#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"
#include "fem/ring_contact/effective_radii.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"

namespace fretval::fem::body_field_test {
namespace {

struct Body {
  HarmonicSpace space;
  Condensation condensation;
  Compliance compliance;

  explicit Body(const FourierOrder& order, double poisson_ratio = 0.5)
      : space(
            [=] {
              auto grid = quarter_disc_grid(1, 16, 20, 0.25);
              grid.elasticity.poisson_ratio = poisson_ratio;
              return grid;
            }(),
            order, 3),
        condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "body"),
        compliance(contact_compliance(space.contact_line(), condensation.schur_complement())) {
    add_far_field(space, condensation, {ring_component(order)}, compliance);
  }

  [[nodiscard]] Eigen::VectorXd extend(const Eigen::VectorXd& rings) const {
    return body_under(space, condensation, tractions_for(compliance, rings));
  }
};

// Roundoff of the two factors, 1e-12 of the stiffest rings; of a compressible body its far boundary leaves the moments
// of the tractions, 4e-6 on 20 radii.
TEST(BodyField, ExtendsTheDisplacementsOfTheRings) {
  for (const auto& [order, poisson_ratio] :
       {std::pair{axisymmetric, 0.5}, {lateral, 0.5}, {axisymmetric, 0.3}, {lateral, 0.3}}) {
    const Body body(order, poisson_ratio);
    const auto& line = body.space.contact_line();
    const Eigen::VectorXd rings = random_vector(16, 1), field = body.extend(rings);
    Eigen::VectorXd on_line(line.loads.rows());
    for (std::size_t i = 0; i < line.dofs.size(); ++i) on_line[static_cast<Eigen::Index>(i)] = field[line.dofs[i]];
    const Eigen::VectorXd means = (line.loads.transpose() * on_line).cwiseQuotient(line.areas);
    EXPECT_LT((means - rings).cwiseAbs().maxCoeff(), poisson_ratio == 0.5 ? 1e-10 : 1e-5) << order.n;
  }
}

// Below a flat punch, on the axis at depth z, nu = 1/2: u_z = (2 d/pi) [atan(a/z) + a z/(a^2 + z^2)] (Sneddon 1946).
// Of 16 rings, second order: 1.1e-4 measured.
TEST(BodyField, SinksBelowAFlatPunchLikeTheHalfSpace) {
  const Body body(axisymmetric);
  const Eigen::VectorXd field = body.extend(Eigen::VectorXd::Ones(16));
  const auto& parts = body.space.parts();
  const double a = effective_radii(body.compliance).radius[16];
  std::vector<dealii::Point<2>> support(parts.dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(), parts.dofs, support);
  const auto vertical = dealii::DoFTools::extract_dofs(parts.dofs, [&] {
    dealii::ComponentMask mask(parts.element.n_components(), false);
    mask.set(vertical_component(axisymmetric), true);
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

// Of a traction on each ring alone, and of none: the columns do not know each other. Roundoff of a solve.
TEST(BodyField, HasAColumnForEachColumnOfTractions) {
  const Body body(lateral);
  Eigen::MatrixXd tractions = Eigen::MatrixXd::Zero(16, 3);
  tractions.col(0) = random_vector(16, 2);
  tractions.col(2) = -3 * tractions.col(0);
  const auto fields = body_under(body.space, body.condensation, tractions);
  EXPECT_LT((fields.col(2) + 3 * fields.col(0)).norm(), 1e-10 * fields.col(2).norm());
  EXPECT_EQ(fields.col(1).norm(), 0);
  EXPECT_GT(fields.col(0).norm(), 0.1);
}

}  // namespace
}  // namespace fretval::fem::body_field_test
