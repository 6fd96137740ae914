#include "fem/contact/require_room.h"

namespace fretval::fem {

void require_room(const Eigen::VectorXd& pressure) {
  if (pressure[pressure.size() - 1] > 0)
    throw NoRoom("the contact reaches the end of the contact line of the mesh: use a longer one");
}

}  // namespace fretval::fem
