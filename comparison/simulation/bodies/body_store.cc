#include "comparison/simulation/bodies/body_store.h"

#include <utility>

#include "comparison/simulation/bodies/kept_body.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
bool is_too_large(std::size_t n_dofs, const BodyStore& bodies) {
  return bodies.distribution && n_dofs >= bodies.distribution->from_dofs;
}

std::shared_ptr<const ContactBody> find_or_make_body(const BodyDescription& description, BodyStore& bodies,
                                                     std::shared_ptr<const Body>* whole) {
  return bodies.find_or_make(description, [&] {
    if (description.scale != 1) {
      auto original = description;
      original.scale = 1;
      return scaled(*find_or_make_body(original, bodies), description.scale);
    }
    if (description.has_merged_rings()) {
      auto unmerged = description;
      unmerged.contact_nodes = std::exchange(unmerged.given.radii, {});
      return with_merged_rings(*find_or_make_body(unmerged, bodies), description.contact_nodes);
    }
    if (description.has_moved_rings()) {
      auto own = description;
      const auto moved = std::exchange(own.moved, {});
      auto coarse = own;
      coarse.contact_nodes = moved.coarse_nodes;
      coarse.far_radius = moved.coarse_far_radius;
      return with_moved_rings(*find_or_make_body(own, bodies), *find_or_make_body(coarse, bodies), moved.factor);
    }
    RingEdges edges;
    if (!description.is_half_space())
      edges = ring_edges(*find_or_make_body(half_space_with_rings_of(description), bodies));
    if (bodies.operators)
      if (auto kept = kept_body(description, edges, *bodies.operators)) {
        ++bodies.n_kept;
        return *std::move(kept);
      }
    Stopwatch watch;
    const auto mesh = bodies.meshes.mesh_of(description);
    const double mesh_seconds = watch.lap();
    if (is_too_large(n_dofs_on(mesh, description.degree, description.tangential), bodies)) {
      auto body = distributed_body(description, edges, *bodies.distribution, bodies.operators.get());
      ++(body.summary->from_store ? bodies.n_kept : bodies.n_made);
      return body;
    }
    ++bodies.n_made;
    auto operators = assemble_operators(mesh, bodies.meshes.name, description);
    operators.cost.mesh = mesh_seconds;
    const auto made = std::make_shared<const Body>(condense(std::move(operators), edges));
    if (whole) *whole = made;
    if (bodies.operators) keep_body(description, *made, *bodies.operators);
    return contact_body(*made);
  });
}

}  // namespace fretval
