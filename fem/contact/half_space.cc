#include "fem/contact/half_space.h"

namespace fretval::fem {

double normal_punch(double poisson_ratio) {
  return 4 / (1 - poisson_ratio);
}

double tangential_punch(double poisson_ratio) {
  return 8 / (2 - poisson_ratio);
}

double normal_over_tangential_punch(double poisson_ratio) {
  return (2 - poisson_ratio) / (2 * (1 - poisson_ratio));
}

}  // namespace fretval::fem
