#include "comparison/simulation/body_store.h"

#include <utility>

#include "comparison/simulation/kept_body.h"
#include "comparison/support/stopwatch.h"

namespace fretval {

std::shared_ptr<const ContactBody> find_or_make_body(const BodySpecification& specification, BodyStore& bodies,
                                                     std::shared_ptr<const Body>* whole) {
  return bodies.find_or_make(specification, [&] {
    if (bodies.operators)
      if (auto kept = kept_body(specification, *bodies.operators)) {
        ++bodies.n_kept;
        return *std::move(kept);
      }
    ++bodies.n_made;
    Stopwatch watch;
    const auto mesh = bodies.meshes.mesh_of(specification);
    const double mesh_seconds = watch.lap();
    auto operators = assemble_operators(mesh, bodies.meshes.name, specification.degree, specification.tangential);
    operators.cost.mesh = mesh_seconds;
    const auto made = std::make_shared<const Body>(condense(std::move(operators)));
    if (whole) *whole = made;
    if (bodies.operators) keep_body(specification, *made, *bodies.operators);
    return contact_body(*made);
  });
}

}  // namespace fretval
