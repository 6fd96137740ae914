#include "fem/full_contact/angular_transform.h"

#include <stdexcept>

#include "fem/support/dense.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

int folds_of(const AngularGrid& grid) {
  const int most = grid.mirrors == Mirrors::none ? 2 : grid.mirrors == Mirrors::x ? 1 : 0;
  int n = 0;
  for (Index m = grid.n_kept(); n < most && m % 2 == 0; m /= 2) ++n;
  return n;
}

/// Whether the mirror image of a part has the other sign: that of t_y has, those of t_x and p have not.
bool turns_around(Index part) {
  return part == 1;
}

}  // namespace

template <class Scalar>
AngularTransform<Scalar>::AngularTransform(const AngularGrid& grid, SurfaceField field,
                                           const std::vector<Amplitude>& amplitudes)
    : n_amplitudes_(static_cast<Index>(amplitudes.size())),
      n_columns_(amplitudes.front().weights.size()),
      n_parts_(field == SurfaceField::tangential ? 2 : 1),
      n_folds_(folds_of(grid)) {
  Matrix weights(n_amplitudes_, n_columns_);
  for (Index i = 0; i < n_amplitudes_; ++i)
    weights.row(i) = amplitudes[static_cast<std::size_t>(i)].weights.template cast<Scalar>();
  fold(weights);
  weights /= static_cast<Scalar>(n_classes());
  Index end = 0;
  for (Index column = 0; column < n_columns_; column += width()) {
    const auto of_class = weights.middleCols(column, width());
    const Index first = end;
    while (end < n_amplitudes_ && 2 * of_class.row(end).squaredNorm() > weights.row(end).squaredNorm()) ++end;
    classes_.push_back(
        {first, of_class.middleRows(first, end - first).transpose(), of_class.middleRows(first, end - first)});
  }
  if (end != n_amplitudes_) throw std::logic_error("amplitudes are not in the order of their symmetries");
}

// A class has all of its parts one after the other, each as wide as half of those of the class that it came from: what
// is even about the mirror before what is odd.
template <class Scalar>
void AngularTransform<Scalar>::fold(Matrix& field) const {
  Matrix folded(field.rows(), n_folds_ > 0 ? n_columns_ : 0);
  for (Index level = 0; level < n_folds_; ++level) {
    const Index width = n_columns_ >> level, half = width / n_parts_ / 2;
    for (Index first = 0; first < n_columns_; first += width)
      for (Index part = 0; part < n_parts_; ++part) {
        const auto near = field.middleCols(first + 2 * part * half, half),
                   far = field.middleCols(first + (2 * part + 1) * half, half);
        auto even = folded.middleCols(first + part * half, half),
             odd = folded.middleCols(first + (n_parts_ + part) * half, half);
        (turns_around(part) ? odd : even) = near + far.rowwise().reverse();
        (turns_around(part) ? even : odd) = near - far.rowwise().reverse();
      }
    field.swap(folded);
  }
}

template <class Scalar>
void AngularTransform<Scalar>::unfold(Matrix& field) const {
  Matrix unfolded(field.rows(), n_folds_ > 0 ? n_columns_ : 0);
  for (Index level = n_folds_ - 1; level >= 0; --level) {
    const Index width = n_columns_ >> level, half = width / n_parts_ / 2;
    for (Index first = 0; first < n_columns_; first += width)
      for (Index part = 0; part < n_parts_; ++part) {
        const auto even = field.middleCols(first + part * half, half),
                   odd = field.middleCols(first + (n_parts_ + part) * half, half);
        unfolded.middleCols(first + 2 * part * half, half) = even + odd;
        auto far = unfolded.middleCols(first + (2 * part + 1) * half, half);
        if (turns_around(part))
          far = (odd - even).rowwise().reverse();
        else
          far = (even - odd).rowwise().reverse();
      }
    field.swap(unfolded);
  }
}

template <class Scalar>
void AngularTransform<Scalar>::amplitudes_of(Matrix field, Eigen::Ref<Matrix> amplitudes) const {
  fold(field);
  Index column = 0;
  for (const auto& [first, weights, transposed] : classes_) {
    multiply(field.middleCols(column, width()), weights, amplitudes.middleCols(first, weights.cols()));
    column += width();
  }
}

template <class Scalar>
void AngularTransform<Scalar>::field_of(const Eigen::Ref<const Matrix>& amplitudes, Matrix& field) const {
  field.resize(amplitudes.rows(), n_columns_);
  Index column = 0;
  for (const auto& [first, weights, transposed] : classes_) {
    multiply(amplitudes.middleCols(first, weights.cols()), transposed, field.middleCols(column, width()));
    column += width();
  }
  unfold(field);
}

template <class Scalar>
Eigen::VectorXd AngularTransform<Scalar>::squares() const {
  Eigen::VectorXd squares(n_amplitudes_);
  for (const auto& [first, weights, transposed] : classes_)
    squares.segment(first, weights.cols()) =
        static_cast<double>(n_classes()) * weights.colwise().squaredNorm().transpose().template cast<double>();
  return squares;
}

template <class Scalar>
AngularTransform<float> AngularTransform<Scalar>::scaled(const Eigen::VectorXd& factors) const {
  AngularTransform<float> result;
  result.n_amplitudes_ = n_amplitudes_;
  result.n_columns_ = n_columns_;
  result.n_parts_ = n_parts_;
  result.n_folds_ = n_folds_;
  for (const auto& [first, weights, transposed] : classes_) {
    const Eigen::MatrixXd times = weights.template cast<double>() * factors.segment(first, weights.cols()).asDiagonal();
    result.classes_.push_back({first, times.cast<float>(), times.transpose().cast<float>()});
  }
  return result;
}

template class AngularTransform<double>;
template class AngularTransform<float>;

}  // namespace fretval::fem
