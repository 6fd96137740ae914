#include "comparison/simulation/body_store.h"

#include <utility>

#include "comparison/support/stopwatch.h"

namespace fretval {

std::shared_ptr<const ContactBody> find_or_make_body(const BodySpecification& specification, BodyStore& bodies,
                                                     std::shared_ptr<const Body>* whole) {
  return bodies.find_or_make(specification, [&] {
    Stopwatch watch;
    const auto mesh = bodies.meshes.mesh_of(specification);
    const double mesh_seconds = watch.lap();
    auto operators = assemble_operators(mesh, bodies.meshes.name, specification.degree, specification.tangential);
    operators.cost.mesh = mesh_seconds;
    const auto made = std::make_shared<const Body>(condense(std::move(operators)));
    if (whole) *whole = made;
    return contact_body(*made);
  });
}

}  // namespace fretval
