#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/full_contact/angular_grid.h"

namespace fretval::fem {

/// From fields on rings x angles to their amplitudes, T, and back by T^T. Each amplitude is even or odd about each of
/// the two axes on which its angles are mirrored, and so is a field with the weights of that amplitude. Sums and
/// differences of a field with its mirror images, a fold for each mirror, therefore leave a quarter of the angles and a
/// quarter of the amplitudes to each of four dense transforms. Scalar: double or float.
template <class Scalar>
class AngularTransform {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  AngularTransform() = default;
  /// amplitudes: of the grid and the field, in the order of amplitudes_of().
  AngularTransform(const AngularGrid& grid, SurfaceField field, const std::vector<Amplitude>& amplitudes);

  /// T f, a row for each ring and a column for each amplitude.
  void amplitudes_of(Matrix field, Eigen::Ref<Matrix> amplitudes) const;
  /// T^T a, a row for each ring and a column for each point of a ring, t_x before t_y.
  void field_of(const Eigen::Ref<const Matrix>& amplitudes, Matrix& field) const;

  [[nodiscard]] Eigen::Index n_amplitudes() const { return n_amplitudes_; }
  [[nodiscard]] Eigen::Index n_columns() const { return n_columns_; }
  /// Per amplitude: the sum of the squares of its weights.
  [[nodiscard]] Eigen::VectorXd squares() const;
  /// The transform with the weights of each amplitude times a factor, in single precision.
  [[nodiscard]] AngularTransform<float> scaled(const Eigen::VectorXd& factors) const;

 private:
  template <class Other>
  friend class AngularTransform;

  /// Amplitudes with the same symmetries, and their weights on the angles that are left by folding.
  struct SymmetryClass {
    Eigen::Index first;  ///< amplitude
    Matrix weights, transposed;
  };

  [[nodiscard]] Eigen::Index n_classes() const { return Eigen::Index{1} << n_folds_; }
  [[nodiscard]] Eigen::Index width() const { return n_columns_ >> n_folds_; }  // columns of a class
  void fold(Matrix& field) const;
  void unfold(Matrix& field) const;

  Eigen::Index n_amplitudes_ = 0, n_columns_ = 0, n_parts_ = 1;
  int n_folds_ = 0;
  std::vector<SymmetryClass> classes_;
};

}  // namespace fretval::fem
