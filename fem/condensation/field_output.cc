#include "fem/condensation/field_output.h"

#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

class Displacements : public dealii::DataPostprocessor<2> {
 public:
  Displacements(Harmonic harmonic, double depth) : harmonic_(harmonic), depth_(depth) {}

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2>& inputs,
                             std::vector<dealii::Vector<double>>& computed) const override {
    for (std::size_t q = 0; q < inputs.solution_values.size(); ++q) {
      const auto& x = inputs.solution_values[q];
      if (harmonic_ == Harmonic::normal) {
        computed[q][0] = -depth_ * x[0];
        computed[q][1] = -depth_ * x[1];
      } else {
        computed[q][0] = depth_ * (x[1] + x[0]);
        computed[q][1] = depth_ * (x[1] - x[0]);
        computed[q][2] = depth_ * x[2];
      }
    }
  }

  [[nodiscard]] std::vector<std::string> get_names() const override {
    if (harmonic_ == Harmonic::normal) return {"u_r", "u_z"};
    return {"u_r_cos", "u_theta_sin", "u_z_cos"};
  }

  [[nodiscard]] dealii::UpdateFlags get_needed_update_flags() const override { return dealii::update_values; }

 private:
  Harmonic harmonic_;
  double depth_;
};

/// DataOut with the patches' corners multiplied by a length; cells are straight, so the corners are all there is.
class ScaledDataOut : public dealii::DataOut<2> {
 public:
  void scale(double length) {
    scaled_ = dealii::DataOut<2>::get_patches();
    for (auto& patch : scaled_)
      for (auto& vertex : patch.vertices) vertex *= length;
  }

 protected:
  [[nodiscard]] const std::vector<dealii::DataOutBase::Patch<2, 2>>& get_patches() const override { return scaled_; }

 private:
  std::vector<dealii::DataOutBase::Patch<2, 2>> scaled_;
};

}  // namespace

Eigen::VectorXd extend_into_body(const HarmonicSpace& space, const Condensation& condensation,
                                 const Compliance& compliance, const Eigen::VectorXd& ring_displacements) {
  const Eigen::LLT<Eigen::MatrixXd> factor(*compliance.matrix);
  if (factor.info() != Eigen::Success) throw SolverError("the contact compliance is not positive definite");
  const Eigen::VectorXd tractions = factor.solve(compliance.areas.cwiseProduct(ring_displacements));
  const auto& line = space.contact_line();
  const Eigen::VectorXd forces = line.loads * tractions;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(space.n_skeleton_dofs());
  for (std::size_t i = 0; i < line.dofs.size(); ++i) rhs[line.dofs[i]] = forces[static_cast<Eigen::Index>(i)];
  return extend_into_cells(space, condensation.solve(rhs));
}

void write_vtu(const HarmonicSpace& space, const Eigen::VectorXd& displacements, double length, double depth,
               std::ostream& stream) {
  dealii::Vector<double> solution(displacements.begin(), displacements.end());
  const Displacements postprocessor(space.harmonic(), depth);
  ScaledDataOut output;
  output.attach_dof_handler(space.parts().dofs);
  output.add_data_vector(solution, postprocessor);
  output.build_patches(space.parts().element.degree);
  output.scale(length);
  output.write_vtu(stream);
}

}  // namespace fretval::fem
