#include "comparison/simulation/bodies/surface_store.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/bodies/operator_key.h"
#include "comparison/support/parallel.h"
#include "fem/condensation/merged_rings.h"
#include "meshes/audit.h"

namespace fretval {
namespace {

std::vector<fem::FourierOrder> orders_up_to(unsigned highest) {
  std::vector<fem::FourierOrder> orders{{0, fem::Parity::odd}};
  for (unsigned n = 0; n <= highest; ++n) orders.push_back({n, fem::Parity::even});
  return orders;
}

fem::Compliance made_block(const BodyDescription& body, const fem::FourierOrder& order, BodyStore& bodies) {
  if (body.has_merged_rings()) {
    auto unmerged = body;
    unmerged.contact_nodes = std::exchange(unmerged.given.radii, {});
    const auto block =
        bodies.surfaces.find_or_make({unmerged, order}, [&] { return made_block(unmerged, order, bodies); });
    return fem::merged_rings(*block, body.contact_nodes);
  }
  const auto key = surface_key(body, order);
  if (bodies.operators)
    if (auto kept = bodies.operators->find(key)) return std::move(kept->compliance);
  const auto mesh = bodies.meshes.mesh_of(body);
  meshes::audit(mesh, bodies.meshes.name);
  auto block = fem::surface_block(grid_of(mesh, body), order, body.degree);
  if (bodies.operators) bodies.operators->keep({key, block, {}});
  return block;
}

/// A block that a factor makes larger with the body: areas grow with its square, the compliance of rings with its cube.
fem::SharedMatrix scaled(const fem::SharedMatrix& block, double factor) {
  return factor == 1 ? block : fem::SharedMatrix(std::pow(factor, 3) * *block);
}

}  // namespace

fem::SurfaceCompliance find_or_make_surface(const BodyDescription& description, unsigned highest_order,
                                            BodyStore& bodies) {
  auto body = description;
  body.scale = 1;
  body.tangential = true;  // orders serve bodies with and without the others
  const double factor = description.scale;
  const auto orders = orders_up_to(highest_order);
  std::vector<std::shared_ptr<const fem::Compliance>> blocks(orders.size());
  for_each_in_parallel(orders.size(), [&](std::size_t k) {
    blocks[k] = bodies.surfaces.find_or_make({body, orders[k]}, [&] { return made_block(body, orders[k], bodies); });
  });
  fem::SurfaceCompliance surface{
      blocks[0]->radii, std::pow(factor, 2) * blocks[0]->areas, scaled(blocks[0]->matrix, factor), {}};
  for (double& radius : surface.radii) radius *= factor;
  for (std::size_t k = 1; k < blocks.size(); ++k) surface.orders.push_back(scaled(blocks[k]->matrix, factor));
  return surface;
}

}  // namespace fretval
