#include "comparison/reference/normal_responses.h"

#include "comparison/reference/mdr_answer.h"

namespace fretval {

std::shared_ptr<const mdr::NormalResponse> NormalResponses::of(const Case& input, const MdrCase& mdr) {
  if (mdr.path) return std::make_shared<const mdr::NormalResponse>(mdr_normal_response(mdr));
  const auto& shape = input.indenter;
  const auto table = shape.trace ? shape.table + ", aligned" : shape.table;
  const Indenter indenter{shape.shape,       shape.radius,   shape.slope_angle,
                          shape.coefficient, shape.exponent, shape.flat_radius,
                          shape.edge_radius, table,          shape.table_noise};
  std::optional<Layer> layer;
  if (mdr.layer) layer = {mdr.layer->thickness, mdr.layer->poisson_ratio, mdr.layer->base == mdr::LayerBase::bonded};
  const Body body{mdr.body.relaxed_modulus, mdr.body.branch_moduli, mdr.body.branch_times, mdr.body.viscosity, layer};
  Motion motion{mdr.normal_force, mdr.motion.indentation, {}};
  for (const auto& [amplitude, frequency, phase, across] : mdr.motion.normal)
    std::get<2>(motion).emplace_back(amplitude, frequency, phase);
  return responses_.find_or_make({indenter, body, motion, mdr.limiting ? mdr.limiting->stick_radius : 0},
                                 [&] { return mdr_normal_response(mdr); });
}

}  // namespace fretval
